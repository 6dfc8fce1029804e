// SPDX-License-Identifier: GPL-3.0-or-later
#include "flows/flow_terms.h"

#include "core/threads.h"

namespace loopmend {

namespace {

constexpr int vertices_at_a_time = 1024;  ///< by a thread: of so little work for each

/// What the terms add up to: V and the parts of V', see FlowSystem.
struct TermSum {
  Eigen::VectorXd velocity;  ///< n
  std::vector<double> A, D;  ///< an entry for each of OperatorSet's in the first n rows
  double b = 0;              ///< factor of Δ(ΔH)
};

/// Adds to row i; terms write to no other row than that of the vertex they are asked for.
using Term = void (*)(const FlowState&, int i, TermSum&);

/// A factor of H_i itself.
void add_on_centre(const FlowState& s, int i, double factor, TermSum& sum) {
  if (s.ops.valid[i]) sum.A[s.ops.offset[i]] += factor;
}

/// H
void mean_curvature(const FlowState& s, int i, TermSum& sum) {
  sum.velocity[i] += s.ops.H[i];
  add_on_centre(s, i, 1, sum);
}

/// −ΔH ≈ −Δ(H^{k+1})
void minus_laplacian_of_H(const FlowState& s, int i, TermSum& sum) {
  sum.velocity[i] -= s.lap_H[i];
  for (int e = s.ops.offset[i]; e < s.ops.offset[i + 1]; ++e) sum.A[e] -= s.ops.laplacian[e];
}

/// −2H(H² − K) ≈ −2(H² − K) H^{k+1}
void willmore_cubic(const FlowState& s, int i, TermSum& sum) {
  const double H = s.ops.H[i], factor = 2 * (H * H - s.ops.K[i]);
  sum.velocity[i] -= factor * H;
  add_on_centre(s, i, -factor, sum);
}

/// Δ²H ≈ Δ(ΔH^{k+1}), whose part of V' is the same in all rows
void bilaplacian_of_H(const FlowState& s, int i, TermSum& sum) { sum.velocity[i] += s.ops.apply_laplacian(i, s.lap_H); }

/// 2(2H² − K)ΔH ≈ (2H^{k+1}H − K^{k+1})ΔH + (2H² − K)ΔH^{k+1}, with K linear in r by its own weights
void curvature_times_laplacian(const FlowState& s, int i, TermSum& sum) {
  const double H = s.ops.H[i], lap = s.lap_H[i], factor = 2 * H * H - s.ops.K[i];
  sum.velocity[i] += 2 * factor * lap;
  add_on_centre(s, i, 2 * H * lap, sum);
  for (int e = s.ops.offset[i]; e < s.ops.offset[i + 1]; ++e) {
    sum.A[e] += factor * s.ops.laplacian[e];
    sum.D[e] -= lap * s.ops.gauss[e] * s.ops.normal[i].dot(s.ops.normal[s.ops.index[e]]);
  }
}

/// 2⟨∇H, ◇H⟩ ≈ ⟨∇H^{k+1}, ◇H⟩ + ⟨∇H, ◇H^{k+1}⟩
void gradient_times_diamond(const FlowState& s, int i, TermSum& sum) {
  sum.velocity[i] += 2 * s.grad_H[i].dot(s.dia_H[i]);
  const Vec3 both = s.dia_H[i] + s.ops.diamond(i, s.grad_H[i]);  // ◇ is ∇ times a symmetric matrix
  for (int e = s.ops.offset[i]; e < s.ops.offset[i + 1]; ++e) sum.A[e] += s.ops.gradient[e].dot(both);
}

/// −2H⟨∇H, ∇H⟩ ≈ −H^{k+1}⟨∇H, ∇H⟩ − H⟨∇H^{k+1}, ∇H⟩
void minus_H_gradient_squared(const FlowState& s, int i, TermSum& sum) {
  const double H = s.ops.H[i], squared = s.grad_H[i].squaredNorm();
  sum.velocity[i] -= 2 * H * squared;
  add_on_centre(s, i, -squared, sum);
  for (int e = s.ops.offset[i]; e < s.ops.offset[i + 1]; ++e) sum.A[e] -= H * s.ops.gradient[e].dot(s.grad_H[i]);
}

std::vector<Term> terms_of(FlowKind flow) {
  switch (flow) {
    case FlowKind::mcf: return {mean_curvature};
    case FlowKind::sdf: return {minus_laplacian_of_H};
    case FlowKind::wf: return {minus_laplacian_of_H, willmore_cubic};
    case FlowKind::mmcvf:
      return {bilaplacian_of_H, curvature_times_laplacian, gradient_times_diamond, minus_H_gradient_squared};
  }
  return {};
}

TermSum add_terms(FlowKind flow, const FlowState& state) {
  TermSum sum;
  sum.velocity.setZero(state.n);
  sum.A.assign(state.ops.offset[state.n], 0);
  sum.D.assign(state.ops.offset[state.n], 0);
  sum.b = flow == FlowKind::mmcvf ? 1 : 0;
  const std::vector<Term> terms = terms_of(flow);
  parallel_for(0, state.n, vertices_at_a_time, [&](int i) {
    for (Term term : terms) term(state, i, sum);
  });
  return sum;
}

/// The first rows of a matrix that has entries where the operators have.
Eigen::Map<const RowSparseMatrix> matrix_of(const OperatorSet& ops, const std::vector<double>& values,
                                            Eigen::Index rows) {
  return {rows, ops.H.size(), ops.offset[rows], ops.offset.data(), ops.index.data(), values.data()};
}

}  // namespace

const char* to_string(FlowKind flow) {
  switch (flow) {
    case FlowKind::mcf: return "mcf";
    case FlowKind::sdf: return "sdf";
    case FlowKind::wf: return "wf";
    case FlowKind::mmcvf: return "mmcvf";
  }
  return "";
}

FlowState::FlowState(const OperatorSet& operators, int free_count)
    : ops(operators),
      n(free_count),
      lap_H(matrix_of(ops, ops.laplacian, ops.H.size()) * ops.H),
      grad_H(free_count),
      dia_H(free_count) {
  parallel_for(0, n, vertices_at_a_time, [&](int i) {
    grad_H[i] = ops.apply_gradient(i, ops.H);
    dia_H[i] = ops.apply_diamond(i, ops.H);
  });
}

FlowSystem::FlowSystem(FlowKind flow, const FlowState& state) : ops_(state.ops), B_(state.ops.index.size()) {
  TermSum sum = add_terms(flow, state);
  velocity_ = std::move(sum.velocity);
  A_ = std::move(sum.A);
  D_ = std::move(sum.D);
  b_ = sum.b;
  const int vertices = static_cast<int>(ops_.H.size());
  parallel_for(0, vertices, vertices_at_a_time, [&](int i) {
    for (int e = ops_.offset[i]; e < ops_.offset[i + 1]; ++e)
      B_[e] = 0.5 * ops_.laplacian[e] * ops_.normal[i].dot(ops_.normal[ops_.index[e]]);
  });
}

Eigen::VectorXd FlowSystem::times_jacobian(const Eigen::VectorXd& s) const {
  const Eigen::Index n = velocity_.size(), vertices = ops_.H.size();
  Eigen::VectorXd displacement = Eigen::VectorXd::Zero(vertices);
  displacement.head(n) = s;
  const Eigen::VectorXd H = matrix_of(ops_, B_, vertices) * displacement;
  Eigen::VectorXd result = matrix_of(ops_, A_, n) * H;
  result += matrix_of(ops_, D_, n) * displacement;
  if (b_ != 0) {
    const Eigen::VectorXd lap_H = matrix_of(ops_, ops_.laplacian, vertices) * H;
    result += b_ * (matrix_of(ops_, ops_.laplacian, n) * lap_H);
  }
  return result;
}

SparseMatrix FlowSystem::jacobian() const {
  const Eigen::Index n = velocity_.size(), vertices = ops_.H.size();
  // By columns, so that the entries of the operators get into order.
  const SparseMatrix B = SparseMatrix(matrix_of(ops_, B_, vertices)).leftCols(n);
  const SparseMatrix D = SparseMatrix(matrix_of(ops_, D_, n)).leftCols(n);
  SparseMatrix A = matrix_of(ops_, A_, n);
  if (b_ != 0) {
    const SparseMatrix L = matrix_of(ops_, ops_.laplacian, vertices), L0 = matrix_of(ops_, ops_.laplacian, n);
    A += b_ * SparseMatrix(L0 * L);
  }
  return SparseMatrix(A * B) + D;
}

Eigen::VectorXd flow_velocity(FlowKind flow, const FlowState& state) { return add_terms(flow, state).velocity; }

}  // namespace loopmend
