#pragma once
/// \file
/// A law that is not in the list of any_law.hpp: whichever struct a caller brings, behind one
/// pointer. Evaluated point by point: it has no inner loops of its own.

#include <memory>
#include <utility>

#include "tlsph/materials/law.hpp"

namespace tlsph {

/// Holds a copy of any ElasticLaw. `SmallStrain` is that law's own `small_strain`.
template <int D, bool SmallStrain>
class GivenLaw {
 public:
  static constexpr std::string_view name = "given";
  static constexpr bool small_strain = SmallStrain;

  template <ElasticLaw<D> Law>
  requires(Law::small_strain == SmallStrain) explicit GivenLaw(Law law)
      : law_(std::make_shared<const Model<Law>>(std::move(law))) {}

  [[nodiscard]] double energy(const Tensor<D>& H) const { return law_->energy(H); }
  [[nodiscard]] Tensor<D> pk1(const Tensor<D>& H) const { return law_->pk1(H); }
  [[nodiscard]] Tensor<D> dpk1(const Tensor<D>& H, const Tensor<D>& dH) const {
    return law_->dpk1(H, dH);
  }
  [[nodiscard]] Tangent<D> tangent(const Tensor<D>& H) const { return law_->tangent(H); }
  [[nodiscard]] double transverse_stretch(const Tensor<D>& H) const {
    return law_->transverse_stretch(H);
  }
  [[nodiscard]] double transverse_stress(const Tensor<D>& H) const {
    return law_->transverse_stress(H);
  }
  [[nodiscard]] double margin(const Tensor<D>& H) const { return law_->margin(H); }

 private:
  struct Interface {
    virtual ~Interface() = default;
    virtual double energy(const Tensor<D>& H) const = 0;
    virtual Tensor<D> pk1(const Tensor<D>& H) const = 0;
    virtual Tensor<D> dpk1(const Tensor<D>& H, const Tensor<D>& dH) const = 0;
    virtual Tangent<D> tangent(const Tensor<D>& H) const = 0;
    virtual double transverse_stretch(const Tensor<D>& H) const = 0;
    virtual double transverse_stress(const Tensor<D>& H) const = 0;
    virtual double margin(const Tensor<D>& H) const = 0;
  };
  template <class Law>
  struct Model final : Interface {
    explicit Model(Law held) : law(std::move(held)) {}
    double energy(const Tensor<D>& H) const override { return law.energy(H); }
    Tensor<D> pk1(const Tensor<D>& H) const override { return law.pk1(H); }
    Tensor<D> dpk1(const Tensor<D>& H, const Tensor<D>& dH) const override {
      return law.dpk1(H, dH);
    }
    Tangent<D> tangent(const Tensor<D>& H) const override { return law.tangent(H); }
    double transverse_stretch(const Tensor<D>& H) const override {
      return law.transverse_stretch(H);
    }
    double transverse_stress(const Tensor<D>& H) const override { return law.transverse_stress(H); }
    double margin(const Tensor<D>& H) const override { return law.margin(H); }
    Law law;
  };

  std::shared_ptr<const Interface> law_;
};

}  // namespace tlsph
