#pragma once
/// \file
/// A law that is not in the list of any_law.hpp: whichever struct a caller brings, behind one
/// pointer. Evaluated point by point: it has no inner loops of its own.

#include <memory>
#include <utility>

#include "tlsph/materials/law.hpp"

namespace tlsph {

/// A law that knows no past, with the functions of those that do.
template <class Given, int D>
struct WithoutMemory : Given {
  explicit WithoutMemory(Given given) : Given(std::move(given)) {}
  [[nodiscard]] Tensor<D> pk1(const Tensor<D>& H, double* /*now*/) const { return Given::pk1(H); }
  [[nodiscard]] int memory() const { return 0; }
  [[nodiscard]] const WithoutMemory& at(const Past&) const { return *this; }
  [[nodiscard]] double dissipated() const { return 0.0; }
};

/// Holds a copy of any ElasticLaw; of a text (law.hpp) that is `Law<Text>`, with or without a
/// memory. `SmallStrain` is that law's own `small_strain`.
template <int D, bool SmallStrain>
class GivenLaw {
 public:
  static constexpr std::string_view name = "given";
  static constexpr bool small_strain = SmallStrain;

  template <ElasticLaw<D> Given>
  requires(Given::small_strain == SmallStrain) explicit GivenLaw(Given law)
      : owned_(std::make_shared<const Model<Given>>(std::move(law))), law_(owned_.get()) {}

  [[nodiscard]] double energy(const Tensor<D>& H) const { return law_->energy(H, past_); }
  [[nodiscard]] Tensor<D> pk1(const Tensor<D>& H, double* now = nullptr) const {
    return law_->pk1(H, past_, now);
  }
  [[nodiscard]] Tensor<D> dpk1(const Tensor<D>& H, const Tensor<D>& dH) const {
    return law_->dpk1(H, dH, past_);
  }
  [[nodiscard]] Tangent<D> tangent(const Tensor<D>& H) const { return law_->tangent(H, past_); }
  [[nodiscard]] double transverse_stretch(const Tensor<D>& H) const {
    return law_->transverse_stretch(H, past_);
  }
  [[nodiscard]] double transverse_stress(const Tensor<D>& H) const {
    return law_->transverse_stress(H, past_);
  }
  [[nodiscard]] double margin(const Tensor<D>& H) const { return law_->margin(H, past_); }

  [[nodiscard]] int memory() const { return law_->memory(); }
  /// Refers to this one, which must outlive it.
  [[nodiscard]] GivenLaw at(const Past& past) const { return GivenLaw(law_, past); }
  [[nodiscard]] double dissipated() const { return law_->dissipated(past_); }

 private:
  struct Interface {
    virtual ~Interface() = default;
    virtual double energy(const Tensor<D>& H, const Past& past) const = 0;
    virtual Tensor<D> pk1(const Tensor<D>& H, const Past& past, double* now) const = 0;
    virtual Tensor<D> dpk1(const Tensor<D>& H, const Tensor<D>& dH, const Past& past) const = 0;
    virtual Tangent<D> tangent(const Tensor<D>& H, const Past& past) const = 0;
    virtual double transverse_stretch(const Tensor<D>& H, const Past& past) const = 0;
    virtual double transverse_stress(const Tensor<D>& H, const Past& past) const = 0;
    virtual double margin(const Tensor<D>& H, const Past& past) const = 0;
    virtual int memory() const = 0;
    virtual double dissipated(const Past& past) const = 0;
  };
  template <class Given>
  struct Model final : Interface {
    static constexpr bool remembers = requires(const Given& law) { law.at(Past{}); };

    explicit Model(Given held) : law(std::move(held)) {}
    double energy(const Tensor<D>& H, const Past& past) const override {
      return at(past).energy(H);
    }
    Tensor<D> pk1(const Tensor<D>& H, const Past& past, double* now) const override {
      return at(past).pk1(H, now);
    }
    Tensor<D> dpk1(const Tensor<D>& H, const Tensor<D>& dH, const Past& past) const override {
      return at(past).dpk1(H, dH);
    }
    Tangent<D> tangent(const Tensor<D>& H, const Past& past) const override {
      return at(past).tangent(H);
    }
    double transverse_stretch(const Tensor<D>& H, const Past& past) const override {
      return at(past).transverse_stretch(H);
    }
    double transverse_stress(const Tensor<D>& H, const Past& past) const override {
      return at(past).transverse_stress(H);
    }
    double margin(const Tensor<D>& H, const Past& past) const override {
      return at(past).margin(H);
    }
    int memory() const override { return law.memory(); }
    double dissipated(const Past& past) const override { return at(past).dissipated(); }

    decltype(auto) at(const Past& past) const { return law.at(past); }
    std::conditional_t<remembers, Given, WithoutMemory<Given, D>> law;
  };

  GivenLaw(const Interface* law, const Past& past) : law_(law), past_(past) {}

  std::shared_ptr<const Interface> owned_;
  const Interface* law_;
  Past past_;
};

}  // namespace tlsph
