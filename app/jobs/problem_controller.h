// SPDX-License-Identifier: GPL-3.0-or-later
// A problem beside filling holes, tried out in the window: posed, evolved before one's eyes, then taken into the
// document or given up. Until then the document is as it was.
#pragma once

#include "document/document.h"
#include "document/problem_commands.h"
#include "jobs/comparison_controller.h"
#include "jobs/fill_controller.h"
#include "pipeline/problem.h"
#include "scene/trial_picture.h"

#include <QObject>

namespace loopmend {

/// A scan as it would be exported: with its patches.
struct ProblemBase {
  std::vector<int> scans;
  ModelPtr model;                        ///< all of them, in their order
  std::vector<std::size_t> first_point;  ///< #scans + 1, into the model's points
  SurfaceShapePtr shape;                 ///< of the model's view
};

struct ProblemRequest {
  QString name;       ///< of what is posed: "Region of bumps.ply"
  QString made_name;  ///< of the surface that would come into the document
  std::vector<int> scans;
  /// Called on a worker with the scans as one surface; may throw Error in words.
  std::function<PosedProblem(const ProblemBase& base, const CancelToken& cancel)> pose;
  ProblemWords command;                                        ///< the same for a shell
  enum class Around { shown, hidden } around = Around::shown;  ///< what the patch does not replace
};

class ProblemController : public QObject {
  Q_OBJECT

 public:
  ProblemController(Document& document, FillController& controller, QObject* parent = nullptr);

  enum class Stage { none, posing, posed, evolving, solved };
  Stage stage() const { return stage_; }
  bool busy() const { return stage_ == Stage::posing || stage_ == Stage::evolving; }
  const QString& name() const { return request_.name; }
  /// What is worth knowing now: remarks, figures; in words.
  const QString& words() const { return words_; }
  const ProblemPicture& picture() const { return picture_; }
  int free_vertices() const { return posed_ ? posed_->problem.start.free_count : 0; }
  const Solution* solution() const { return solution_.get(); }

  void pose(ProblemRequest request);
  /// From the posed start. Each accepted state is shown.
  void evolve(const EvolutionOptions& options);
  /// Comes back at once: what was under way is given up.
  void cancel();
  /// The solution comes into the document in place of its scans; can be undone.
  void accept();
  void discard();

  /// The same problem for a comparison of flows; its winner comes into the document likewise.
  bool can_compare() const { return posed_ != nullptr && !busy(); }
  ComparisonSource comparison_source() const;
  const ProblemWords& command() const { return request_.command; }
  /// @returns what to tell the person.
  QString adopt(const ComparedRun& flow_run);
  bool shut_down(std::chrono::milliseconds at_most);

 Q_SIGNALS:
  void stage_changed();
  void picture_changed();
  void failed(const QString& words);
  void accepted(const QString& words);

 private:
  struct Post;
  void forget();
  void go_to(Stage stage, const QString& words);
  void fail(const QString& words, Stage back_to);
  void on_posed(std::shared_ptr<const ProblemBase> base, std::shared_ptr<const PosedProblem> posed,
                SurfaceShapePtr start, SurfaceShapePtr backdrop);
  void show_state(const std::shared_ptr<Post>& post);
  void on_solved(std::shared_ptr<const Solution> solution, const OpenedScanPtr& made, SurfaceShapePtr shape);
  void watch_scans();

  Document& document_;
  FillController& controller_;
  Stage stage_ = Stage::none;
  ProblemRequest request_;
  std::vector<ModelPtr> models_;        ///< of the request's scans, as they were
  std::vector<PatchStatePtr> patches_;  ///< of their patches, likewise
  QString words_;
  ProblemPicture picture_;
  std::shared_ptr<const ProblemBase> base_;
  std::shared_ptr<const PosedProblem> posed_;
  SurfaceShapePtr start_shape_;
  std::shared_ptr<const Solution> solution_;
  OpenedScanPtr made_;
  JobPtr job_;
  TaskRunner tasks_;
};

}  // namespace loopmend
