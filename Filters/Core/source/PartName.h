// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PartName_h
#define geodesic_PartName_h

#include <string>
#include <utility>

namespace geodesic
{

/// What messages call an input, or a part of it: "point 3 of cell 2 of the source (input port 1)".
/// The part and the input are kept apart, as some messages leave the input out.
class PartName
{
public:
  PartName() = default;
  /// \param input in lower case: "the source (input port 1)".
  explicit PartName(std::string input)
    : input_(std::move(input))
  {
  }

  /// A part of this: "block 3 (wing)".
  PartName part(const std::string& name) const
  {
    PartName result = *this;
    result.part_ = this->part_.empty() ? name : name + " of " + this->part_;
    return result;
  }
  /// A part of this by its number: "cell 2".
  template <typename Number>
  PartName part(const char* kind, Number number) const
  {
    return this->part(kind + (' ' + std::to_string(number)));
  }
  /// The same part of what one rank has of the input.
  PartName onRank(int rank) const
  {
    PartName result = *this;
    result.input_ += " on rank " + std::to_string(rank);
    return result;
  }

  std::string text() const
  {
    return this->part_.empty() ? this->input_ : this->part_ + " of " + this->input_;
  }
  /// The text at the beginning of a sentence; empty for an input without a name.
  std::string atBeginning() const
  {
    std::string text = this->text();
    if (!text.empty() && text.front() >= 'a' && text.front() <= 'z')
    {
      text.front() = static_cast<char>(text.front() - 'a' + 'A');
    }
    return text;
  }
  /// "point 3 of cell 2"; empty if this is the input itself.
  const std::string& withoutInput() const { return this->part_; }

private:
  std::string part_;
  std::string input_;
};

}

#endif
