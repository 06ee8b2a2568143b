// The [[law]] tables of a model file: terms that no name of the library stands for.
//
//   [[law]]
//   acts_on = "exponent"          exponent, force, gain or offset
//   site = "sheath"               "tube of finger 1", "T3", "motor", "all channels", …
//   form = "linear"               constant, linear, log, power, scaling, quadratic, exponential,
//                                 hinge, step, sine or product
//   covariate = "humidity_pct"    a column of the data, load, or another channel; not of a constant
//   middle = 50                   where the data had their middle
//   range = [20, 80]              that the data had; outside it the law is held constant
//   a = 0.0083                    every parameter of the form
//
// A product has two of covariate, middle and range, and `logarithmic = [true, false]`.
#pragma once

#include <string>

#include "catalog/catalogue.hpp"
#include "catalog/toml_node.hpp"
#include "causes/model.hpp"

namespace reeve::catalog {

// A routing in a site is a word or a name of the catalogue.
Effect read_law(const TomlNode& table, const Catalogue& catalogue);

std::string law_toml(const Effect& effect);

}  // namespace reeve::catalog
