// Columns that no model knows: numbers, or words. A column most of whose cells are words is passed
// over; in another one, words are faults.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "readings/fault_list.hpp"
#include "readings/measured_data.hpp"

namespace reeve::readings {

class Covariates {
 public:
  explicit Covariates(std::vector<std::string> names)
      : names_(std::move(names)), columns_(names_.size()) {}

  std::size_t count() const { return names_.size(); }
  void add_number(std::size_t covariate) { ++columns_[covariate].numbers; }
  void add_fault(std::size_t covariate, std::size_t line, const std::string& kind,
                 const InputFault& fault) {
    columns_[covariate].faults.add(line, kind, fault);
  }

  // Once all rows are read: the names go into the data, columns of words leave the readings with a
  // note, and the faults of the others join the list.
  void finish(MeasuredData& data, FaultList& faults) const;

 private:
  struct Column {
    std::size_t numbers = 0;
    FaultList faults;
  };

  bool is_of_words(std::size_t covariate) const {
    return columns_[covariate].faults.count() > columns_[covariate].numbers;
  }

  std::vector<std::string> names_;
  std::vector<Column> columns_;
};

}  // namespace reeve::readings
