// The explicit finite element that particles have to beat: one stress point an element, its B
// matrix stored, lumped mass, central differences, hourglass stiffness of assumed strain (Flanagan
// & Belytschko 1981, Belytschko & Bachrach 1986). Q4 in plane strain, bars of two nodes in one
// dimension.
//
//     fe_q4 < problem > result        both as fe_q4.py writes and reads them
//
// Elements go through in blocks of W, a lane of a vector each; only the nodes are read and summed
// into one by one. The clock runs for the steps alone.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

constexpr int W = 8;
using Lanes [[gnu::vector_size(W * sizeof(double))]] = double;

struct Problem {
  std::string law;  // linear-elastic or neo-hookean
  double lambda, mu, density, hourglass;
  int nodes, elements;
  std::vector<double> X, u, v, load;  // N×D; the load is the nodal force at curve = 1
  std::vector<int> corners, free;     // E×2^D in cyclic order; N×D, 1 where the node may move
  std::vector<double> curve_time, curve;
  double end, safety;
  int probe, every;  // node and steps of the recorded history
};

template <int D>
struct Block {
  static constexpr int corners = 1 << D;
  int node[corners][W];
  Lanes B[corners][D], gamma[corners], volume;
};

template <int D>
class Mesh {
 public:
  static constexpr int C = 1 << D;

  explicit Mesh(const Problem& p)
      : lambda(p.lambda), mu(p.mu), linear(p.law == "linear-elastic"), hourglass(p.hourglass) {
    inverse_mass.assign(p.X.size(), 0.0);
    for (int e = 0; e < p.elements; ++e) {
      if (e % W == 0)
        blocks.emplace_back();  // zeroed: a lane without element has no B and no force
      set_element(p, e, blocks.back(), e % W);
    }
    for (size_t k = 0; k < p.X.size(); ++k) inverse_mass[k] = p.free[k] / inverse_mass[k];
  }

  // f −= ∂U/∂u; stress of element e in P[e] if asked for.
  void add_forces(const std::vector<double>& u, std::vector<double>& f,
                  std::vector<double>* stress = nullptr) const {
    for (const Block<D>& b : blocks) {
      Lanes H[D][D] = {}, P[D][D], mode[D] = {};
      for (int q = 0; q < C; ++q)
        for (int i = 0; i < D; ++i) {
          Lanes x;
          for (int l = 0; l < W; ++l) x[l] = u[b.node[q][l] * D + i];
          for (int a = 0; a < D; ++a) H[i][a] += b.B[q][a] * x;
          mode[i] += b.gamma[q] * x;
        }
      linear ? hooke(H, P) : neo_hooke(H, P);
      if (stress)
        for (int l = 0; l < W; ++l)
          for (int i = 0; i < D * D; ++i)
            (*stress)[((&b - blocks.data()) * W + l) * D * D + i] = P[i / D][i % D][l];
      for (int i = 0; i < D; ++i) {
        for (int a = 0; a < D; ++a) P[i][a] *= b.volume;
        mode[i] *= hourglass;
      }
      for (int q = 0; q < C; ++q)
        for (int i = 0; i < D; ++i) {
          Lanes force = b.gamma[q] * mode[i];
          for (int a = 0; a < D; ++a) force += b.B[q][a] * P[i][a];
          for (int l = 0; l < W; ++l) f[b.node[q][l] * D + i] -= force[l];
        }
    }
  }

  // 2/ω_max by power iteration about the reference state.
  double critical_step() const {
    std::vector<double> x(inverse_mass.size()), f(x.size());
    for (size_t k = 0; k < x.size(); ++k)
      x[k] =
          inverse_mass[k] > 0 ? std::cos(2.7 * static_cast<double>(k)) + (k % 2 ? 0.5 : -0.5) : 0.0;
    double square = 0.0;
    for (int iteration = 0; iteration < 400; ++iteration) {
      double norm = 0.0;
      for (const double value : x) norm = std::max(norm, std::abs(value));
      for (double& value : x) value *= 1e-9 / norm;  // small: every law is linear there
      std::fill(f.begin(), f.end(), 0.0);
      add_forces(x, f);
      double work = 0.0, mass = 0.0;
      for (size_t k = 0; k < x.size(); ++k)
        if (inverse_mass[k] > 0) work -= x[k] * f[k], mass += x[k] * x[k] / inverse_mass[k];
      square = work / mass;
      for (size_t k = 0; k < x.size(); ++k) x[k] = -inverse_mass[k] * f[k];
    }
    return 2.0 / std::sqrt(square);
  }

  std::vector<double> inverse_mass;  // N×D, zero where held
  std::vector<Block<D>> blocks;

 private:
  void set_element(const Problem& p, int e, Block<D>& b, int l) {
    const int* at = &p.corners[static_cast<size_t>(e) * C];
    const auto x = [&](int q, int a) { return p.X[at[q] * D + a]; };
    if constexpr (D == 1) {
      b.volume[l] = x(1, 0) - x(0, 0);
      b.B[0][0][l] = -1.0 / b.volume[l], b.B[1][0][l] = 1.0 / b.volume[l];
    } else {
      b.volume[l] = 0.5 * ((x(2, 0) - x(0, 0)) * (x(3, 1) - x(1, 1)) +
                           (x(1, 0) - x(3, 0)) * (x(2, 1) - x(0, 1)));
      constexpr double h[4] = {1, -1, 1, -1};
      double hx[2] = {};
      for (int q = 0; q < 4; ++q) {
        const int next = (q + 1) % 4, last = (q + 3) % 4;
        b.B[q][0][l] = 0.5 * (x(next, 1) - x(last, 1)) / b.volume[l];
        b.B[q][1][l] = 0.5 * (x(last, 0) - x(next, 0)) / b.volume[l];
        for (int a = 0; a < 2; ++a) hx[a] += h[q] * x(q, a);
      }
      for (int q = 0; q < 4; ++q)
        b.gamma[q][l] = 0.25 * (h[q] - b.B[q][0][l] * hx[0] - b.B[q][1][l] * hx[1]);
    }
    for (int q = 0; q < C; ++q) {
      b.node[q][l] = at[q];
      for (int i = 0; i < D; ++i)
        inverse_mass[at[q] * D + i] += p.density * b.volume[l] / C;  // mass, to be inverted
    }
  }

  void hooke(const Lanes (&H)[D][D], Lanes (&P)[D][D]) const {
    Lanes trace = {};
    for (int a = 0; a < D; ++a) trace += H[a][a];
    for (int i = 0; i < D; ++i)
      for (int a = 0; a < D; ++a)
        P[i][a] = mu * (H[i][a] + H[a][i]) + (i == a ? lambda * trace : Lanes{});
  }

  // P = μ(F − F⁻ᵀ) + λ ln J F⁻ᵀ, J = 1 + e.
  void neo_hooke(const Lanes (&H)[D][D], Lanes (&P)[D][D]) const {
    if constexpr (D == 1) {
      const Lanes e = H[0][0];
      P[0][0] = (mu * e * (2.0 + e) + lambda * log_volume(e)) / (1.0 + e);
    } else {
      const Lanes e = H[0][0] + H[1][1] + H[0][0] * H[1][1] - H[0][1] * H[1][0];
      const Lanes off = (lambda * log_volume(e) - mu) / (1.0 + e);
      P[0][0] = mu * (1.0 + H[0][0]) + off * (1.0 + H[1][1]);
      P[1][1] = mu * (1.0 + H[1][1]) + off * (1.0 + H[0][0]);
      P[0][1] = mu * H[0][1] - off * H[1][0];
      P[1][0] = mu * H[1][0] - off * H[0][1];
    }
  }

  // ln(1 + e) = 2 artanh(e/(2 + e)): to round-off where |e| ≤ 0.2 in every lane, else one by one.
  static Lanes log_volume(Lanes e) {
    double largest = 0.0;
    for (int l = 0; l < W; ++l) largest = std::max(largest, std::abs(e[l]));
    if (largest > 0.2) {
      for (int l = 0; l < W; ++l) e[l] = std::log1p(e[l]);
      return e;
    }
    const Lanes z = e / (2.0 + e), w = z * z;
    Lanes sum = w * (1.0 / 15);
    for (const double k : {13.0, 11.0, 9.0, 7.0, 5.0, 3.0}) sum = w * (1.0 / k + sum);
    return 2.0 * z * (1.0 + sum);
  }

  double lambda, mu;
  bool linear;
  double hourglass;
};

template <class T>
std::vector<T> read(size_t count) {
  std::vector<T> values(count);
  for (T& value : values) std::cin >> value;
  return values;
}

void print(const char* name, const std::vector<double>& values) {
  std::cout << name;
  for (const double value : values) std::cout << ' ' << value;
  std::cout << '\n';
}

template <int D>
void solve(Problem& p) {
  const Mesh<D> mesh(p);
  const double critical = mesh.critical_step();
  const long steps = static_cast<long>(std::ceil(p.end / (p.safety * critical)));
  const double dt = p.end / static_cast<double>(steps);
  std::vector<double> f(p.X.size()), time, history;
  const auto forces = [&](double t) {
    double factor = 0.0;
    if (!p.curve.empty()) {
      const double at = t / p.curve_time.back() * static_cast<double>(p.curve.size() - 1);
      const size_t k = std::min(static_cast<size_t>(at), p.curve.size() - 2);
      factor = p.curve[k] + (at - static_cast<double>(k)) * (p.curve[k + 1] - p.curve[k]);
    }
    for (size_t k = 0; k < f.size(); ++k) f[k] = factor * p.load[k];
    mesh.add_forces(p.u, f);
  };
  const auto start = std::chrono::steady_clock::now();
  for (long n = 0; n < steps; ++n) {
    if (n % p.every == 0)
      time.push_back(static_cast<double>(n) * dt), history.push_back(p.u[p.probe]);
    forces(static_cast<double>(n) * dt);
    const double kick = n == 0 ? 0.5 * dt : dt;  // v at n + ½
    for (size_t k = 0; k < f.size(); ++k) {
      p.v[k] += kick * mesh.inverse_mass[k] * f[k];
      p.u[k] += dt * p.v[k];
    }
  }
  forces(p.end);
  for (size_t k = 0; k < f.size(); ++k) p.v[k] += 0.5 * dt * mesh.inverse_mass[k] * f[k];
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  time.push_back(p.end), history.push_back(p.u[p.probe]);
  std::vector<double> stress(mesh.blocks.size() * W * D * D);
  mesh.add_forces(p.u, f, &stress);
  stress.resize(static_cast<size_t>(p.elements) * D * D);
  std::cout.precision(17);
  std::cout << "steps " << steps << "\nstepping_seconds " << seconds.count() << "\ndt_critical "
            << critical << '\n';
  print("displacement", p.u), print("velocity", p.v), print("stress", stress);
  print("time", time), print("history", history);
}

int main() {
  Problem p;
  int dimension = 0, samples = 0;
  std::cin >> dimension >> p.law >> p.lambda >> p.mu >> p.density >> p.hourglass >> p.end >>
      p.safety >> p.nodes >> p.elements >> samples >> p.probe >> p.every;
  const size_t values = static_cast<size_t>(p.nodes) * dimension;
  p.X = read<double>(values);
  p.corners = read<int>(static_cast<size_t>(p.elements) << dimension);
  p.free = read<int>(values);
  p.u = read<double>(values), p.v = read<double>(values), p.load = read<double>(values);
  p.curve_time = read<double>(samples), p.curve = read<double>(samples);
  if (!std::cin) return std::cerr << "fe_q4: the problem ends early\n", 2;
  dimension == 1 ? solve<1>(p) : solve<2>(p);
}
