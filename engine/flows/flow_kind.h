// SPDX-License-Identifier: GPL-3.0-or-later
// The four geometric flows by name.
#pragma once

namespace loopmend {

enum class FlowKind {
  mcf,    ///< mean curvature flow, second order
  sdf,    ///< surface diffusion flow, fourth order
  wf,     ///< Willmore flow, fourth order
  mmcvf,  ///< minimal mean-curvature-variation flow, sixth order (paper eq. 3.8)
};

}  // namespace loopmend
