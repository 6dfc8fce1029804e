// SPDX-License-Identifier: GPL-3.0-or-later
// Candidates, their panel and the view: draws their small pictures as the view looks at the hole, and shows one of them there.
#pragma once

#include "views/camera_flight.h"

#include <QObject>
#include <QTimer>

#include <deque>
#include <memory>

namespace loopmend {

class CandidateController;
class CandidatePictures;
class CandidatesPanel;
class Document;
class MeshView;
struct SurfaceShape;
enum class CandidateKind;

class CandidateBinder : public QObject {
  Q_OBJECT

 public:
  CandidateBinder(const Document& document, CandidateController& candidates, CandidatesPanel& panel, MeshView& view,
                  QObject* parent = nullptr);
  ~CandidateBinder() override;

 private:
  void show_looked_at();
  void draw_soon();
  void draw_again_if_turned();
  void draw_next();
  bool is_shown() const;

  const Document& document_;
  CandidateController& candidates_;
  CandidatesPanel& panel_;
  MeshView& view_;
  std::unique_ptr<CandidatePictures> pictures_;
  QTimer timer_{this}, turned_{this};
  std::shared_ptr<const SurfaceShape> neighborhood_;                                      ///< as it was drawn last
  std::deque<CandidateKind> waiting_;                                                     ///< for their pictures
  Eigen::Vector3d towards_eye_ = Eigen::Vector3d::Zero(), up_ = Eigen::Vector3d::Zero();  ///< of the last pictures
};

}  // namespace loopmend
