// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Errors_h
#define geodesic_Errors_h

#include <stdexcept>
#include <string>

namespace geodesic
{

/// Base of all errors that the engine throws. Messages name what is wrong, where, and what to do;
/// the filter passes them to vtkErrorMacro unchanged.
class Error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// The surface cannot be used: no faces, coordinates that are not finite, ids out of range.
class MeshError : public Error
{
public:
  using Error::Error;
};

/// The surface has more faces than Id can number.
class MeshTooLarge : public MeshError
{
public:
  using MeshError::MeshError;
};

/// The source cannot be used: it is empty, not finite, or joins different components.
class SourceError : public Error
{
public:
  using Error::Error;
};

/// The watcher of the caller's job asked to stop. This is not an error to report.
class Aborted : public Error
{
public:
  Aborted()
    : Error("The computation was aborted.")
  {
  }
};

}

#endif
