// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMGeodesicSourceProxy
 * @brief   proxy of the geodesic filters, on ParaView's client
 *
 * ParaView asks for what a filter tells of its last execution (information properties) when its
 * pipeline information is updated, which a pipeline that executes does not do: this proxy asks
 * after every execution, so that the panel and Python have the numbers of the result that is there.
 *
 * ParaView chooses what colors show when something is shown first. Where the first execution has
 * failed, this proxy has the choice made when there is a result.
 *
 * In XML its element is GeodesicSourceProxy, in place of SourceProxy.
 */

#ifndef vtkSMGeodesicSourceProxy_h
#define vtkSMGeodesicSourceProxy_h

#include "vtkSMSourceProxy.h"

#include <set>
#include <vector>

class vtkSMGeodesicSourceProxy : public vtkSMSourceProxy
{
public:
  static vtkSMGeodesicSourceProxy* New();
  vtkTypeMacro(vtkSMGeodesicSourceProxy, vtkSMSourceProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSMGeodesicSourceProxy();
  ~vtkSMGeodesicSourceProxy() override;

  /// Called when the pipeline has been updated.
  void PostUpdateData(bool usingCache) override;

private:
  vtkSMGeodesicSourceProxy(const vtkSMGeodesicSourceProxy&) = delete;
  void operator=(const vtkSMGeodesicSourceProxy&) = delete;

  bool IsOutputEmpty(unsigned int port);
  void ColorNewResult();

  /// Of each output port, whether the update before has left it empty.
  std::vector<bool> WasEmpty;
  /// Representations for which ParaView had something to choose from; only to be compared.
  std::set<vtkSMProxy*> Chosen;
};

/// Makes ParaView find the class by its name in the XML. The plugin calls it when it is loaded.
void registerGeodesicSourceProxy();

#endif
