#include "flows/flow_terms.h"

namespace loopmend {

namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

/// What one term adds to the system: V, and J = A B + D with A acting on H and D on s.
struct TermSum {
  Eigen::VectorXd velocity;  ///< n
  RowSparseMatrix A;         ///< n by #V
  RowSparseMatrix D;         ///< n by n
};

using Term = void (*)(const FlowState&, TermSum&);

RowSparseMatrix rows_matrix(Eigen::Index rows, Eigen::Index cols, const Triplets& triplets) {
  RowSparseMatrix matrix(rows, cols);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}

RowSparseMatrix diagonal_on_free(const FlowState& s, const Eigen::VectorXd& values) {
  Triplets triplets;
  for (int i = 0; i < s.n; ++i) triplets.emplace_back(i, i, values[i]);
  return rows_matrix(s.n, s.ops.H.size(), triplets);
}

/// H
void mean_curvature(const FlowState& s, TermSum& sum) {
  sum.velocity += s.ops.H.head(s.n);
  sum.A += diagonal_on_free(s, Eigen::VectorXd::Ones(s.n));
}

/// −ΔH ≈ −Δ(H^{k+1})
void minus_laplacian_of_H(const FlowState& s, TermSum& sum) {
  sum.velocity -= s.lap_H.head(s.n);
  sum.A -= RowSparseMatrix(s.L.topRows(s.n));
}

/// −2H(H² − K) ≈ −2(H² − K) H^{k+1}
void willmore_cubic(const FlowState& s, TermSum& sum) {
  const Eigen::ArrayXd H = s.ops.H.head(s.n).array(), K = s.ops.K.head(s.n).array();
  const Eigen::VectorXd factor = 2 * (H.square() - K);
  sum.velocity -= factor.cwiseProduct(s.ops.H.head(s.n));
  sum.A -= diagonal_on_free(s, factor);
}

/// Δ²H ≈ Δ(ΔH^{k+1})
void bilaplacian_of_H(const FlowState& s, TermSum& sum) {
  const RowSparseMatrix L0 = s.L.topRows(s.n);
  sum.velocity += L0 * s.lap_H;
  sum.A += RowSparseMatrix(L0 * s.L);
}

/// 2(2H² − K)ΔH ≈ (2H^{k+1}H − K^{k+1})ΔH + (2H² − K)ΔH^{k+1}, with K linear in r by its own weights
void curvature_times_laplacian(const FlowState& s, TermSum& sum) {
  const Eigen::ArrayXd H = s.ops.H.head(s.n).array(), K = s.ops.K.head(s.n).array();
  const Eigen::VectorXd lap = s.lap_H.head(s.n);
  const Eigen::VectorXd factor = 2 * H.square() - K;
  sum.velocity += 2 * factor.cwiseProduct(lap);
  sum.A += RowSparseMatrix(factor.asDiagonal() * RowSparseMatrix(s.L.topRows(s.n)));
  sum.A += diagonal_on_free(s, (2 * H * lap.array()).matrix());
  Triplets gauss;
  for (int i = 0; i < s.n; ++i)
    for (int e = s.ops.offset[i]; e < s.ops.offset[i + 1]; ++e) {
      const int j = s.ops.index[e];
      if (j < s.n) gauss.emplace_back(i, j, -lap[i] * s.ops.gauss[e].dot(s.ops.normal[j]));
    }
  sum.D += rows_matrix(s.n, s.n, gauss);
}

/// 2⟨∇H, ◇H⟩ ≈ ⟨∇H^{k+1}, ◇H⟩ + ⟨∇H, ◇H^{k+1}⟩
void gradient_times_diamond(const FlowState& s, TermSum& sum) {
  Triplets triplets;
  for (int i = 0; i < s.n; ++i) {
    sum.velocity[i] += 2 * s.grad_H[i].dot(s.dia_H[i]);
    for (int e = s.ops.offset[i]; e < s.ops.offset[i + 1]; ++e)
      triplets.emplace_back(i, s.ops.index[e], s.ops.gradient[e].dot(s.dia_H[i]) + s.ops.diamond[e].dot(s.grad_H[i]));
  }
  sum.A += rows_matrix(s.n, s.ops.H.size(), triplets);
}

/// −2H⟨∇H, ∇H⟩ ≈ −H^{k+1}⟨∇H, ∇H⟩ − H⟨∇H^{k+1}, ∇H⟩
void minus_H_gradient_squared(const FlowState& s, TermSum& sum) {
  Triplets triplets;
  for (int i = 0; i < s.n; ++i) {
    const double squared = s.grad_H[i].squaredNorm();
    sum.velocity[i] -= 2 * s.ops.H[i] * squared;
    triplets.emplace_back(i, i, -squared);
    for (int e = s.ops.offset[i]; e < s.ops.offset[i + 1]; ++e)
      triplets.emplace_back(i, s.ops.index[e], -s.ops.H[i] * s.ops.gradient[e].dot(s.grad_H[i]));
  }
  sum.A += rows_matrix(s.n, s.ops.H.size(), triplets);
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
  sum.A.resize(state.n, state.ops.H.size());
  sum.D.resize(state.n, state.n);
  for (Term term : terms_of(flow)) term(state, sum);
  return sum;
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

FlowState::FlowState(const OperatorSet& operators, int free_count) : ops(operators), n(free_count) {
  const int vertices = static_cast<int>(ops.H.size());
  Triplets laplacian, curvature;
  lap_H.setZero(vertices);
  for (int i = 0; i < vertices; ++i) {
    for (int e = ops.offset[i]; e < ops.offset[i + 1]; ++e) {
      const int j = ops.index[e];
      laplacian.emplace_back(i, j, ops.laplacian[e]);
      if (j < n) curvature.emplace_back(i, j, 0.5 * ops.laplacian[e] * ops.normal[i].dot(ops.normal[j]));
    }
    lap_H[i] = ops.apply_laplacian(i, ops.H);
  }
  L = rows_matrix(vertices, vertices, laplacian);
  B = rows_matrix(vertices, n, curvature);
  for (int i = 0; i < n; ++i) {
    grad_H.push_back(ops.apply_gradient(i, ops.H));
    dia_H.push_back(ops.apply_diamond(i, ops.H));
  }
}

FlowSystem assemble_flow(FlowKind flow, const FlowState& state) {
  TermSum sum = add_terms(flow, state);
  return {std::move(sum.velocity), SparseMatrix(RowSparseMatrix(sum.A * state.B) + sum.D)};
}

Eigen::VectorXd flow_velocity(FlowKind flow, const FlowState& state) { return add_terms(flow, state).velocity; }

}  // namespace loopmend
