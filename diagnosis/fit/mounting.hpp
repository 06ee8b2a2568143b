// Mounting scatter: the readings of one mounting (one routing in one run) share its effects on the
// friction of each contact and on the gain and the zero of each channel.
//
//   φ_c = φ (1 + τ z_c),   T_j = T_j (1 + τ z_j) + τ_0 T̃ z_0j,   z standard normal, new in each
//   mounting; T̃ the median reading
//
// to first order: with D the standard deviations of the readings' own noise and j_k the change of
// the mounting's readings by the k-th of these, the readings of a mounting have the covariance
//
//   D² + Σ_k τ_k² j_k j_kᵀ
//
// of a linear mixed model. The scatter τ is one number for each kind of thing that is mounted.
// Where friction is strong and readings are many, a second order can be seen: the change by two
// exponents together, τ_a τ_b z_a z_b ∂²T/∂z_a∂z_b, is taken for one more thing that scatters with
// the same variance.
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "causes/model.hpp"
#include "diagnosis/dataset.hpp"
#include "numerics/parallel.hpp"

namespace reeve::diagnosis {

// Exponents of sheaths, tubes and bearings, gains and zeros of channels; the motor tension has a
// gain, too.
enum class Mounted : std::uint8_t { sheath, tube, bearing, gain, zero };
inline constexpr std::size_t mounted_kinds = 5;
const char* mounted_name(Mounted kind);
// As what a contact is mounted; none for those that no mounting changes.
std::optional<Mounted> mounted_kind(ContactKind contact);

// Relative, one standard deviation from mounting to mounting; of zeros to the median reading.
using MountedScatter = std::array<double, mounted_kinds>;

struct Mounting {
  std::size_t run = 0;      // in MeasuredData::runs
  std::size_t routing = 0;  // in MeasuredData::routings
  std::vector<Eigen::Index> cells;
};

// Contacts of the kind in the routing that has the most of them.
std::size_t most_of_a_kind(const Dataset& dataset, ContactKind kind);

// Exponents that change as this says, in every routing: no cause that anybody would name, but what
// differs between mountings, and what laws of contacts act through.
class ChangedExponents final : public Cause {
 public:
  using Change = std::function<double(double phi, const ContactLoad&)>;
  explicit ChangedExponents(Change change) : change_(std::move(change)) {}

  const char* name() const override { return "changed_exponents"; }
  Reach reach() const override { return Reach::exponent; }
  const char* meaning() const override { return "the exponents of contacts differ"; }
  std::vector<Parameter> parameters(const Hardware&) const override { return {}; }
  std::vector<Subject> subjects(const Survey&) const override { return {}; }
  double exponent(double phi, const ContactLoad& load, const Conditions&,
                  const Effect&) const override {
    return change_(phi, load);
  }

 private:
  Change change_;
};

// The n-th contact of a kind, in every routing.
struct NumberedContact {
  ContactKind kind = ContactKind::sheath;
  std::size_t number = 0;

  bool is(const ContactLoad& load) const { return load.kind == kind && load.number == number; }
};

// In the order of run and routing.
std::vector<Mounting> mountings(const Dataset& dataset);

// One column for each thing that a mounting changes: the n-th contact of a kind in the routing's
// network, or a channel. It acts in each mounting by itself.
struct MountingModes {
  std::vector<Mounted> kind;   // kind of thing of each column
  Eigen::MatrixXd by_share_N;  // change of each cell by a relative change of the thing

  // Joint effect of two exponents; with itself: half the second derivative times √2, the deviation
  // of z².
  struct Pair {
    Mounted first = Mounted::sheath;
    Mounted second = Mounted::sheath;
    Eigen::VectorXd by_shares_N;
  };
  std::vector<Pair> pairs;
};

// At these tensions of the model; things without effect have no column, and a model without
// tensions a little beside it none at all.
MountingModes mounting_modes(const Dataset& dataset, const Model& model, Workers& workers);

}  // namespace reeve::diagnosis
