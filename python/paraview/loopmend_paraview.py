# SPDX-License-Identifier: GPL-3.0-or-later
"""A filter for ParaView: Tools > Manage Plugins > Load New, and choose this file. The Python module loopmend must be found by
ParaView's Python, whose version its wheel must have: see docs/user/paraview_and_slicer.md.
"""
from paraview.util.vtkAlgorithm import smdomain, smhint, smproperty, smproxy
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonDataModel import vtkPolyData

CONTINUITY = ("position", "tangent", "curvature")
BOUNDARY = ("auto", "exact", "robust")


def enumeration(words):
    """The list of choices of ParaView's panel: numbers with their words."""
    entries = "".join(f'<Entry text="{word}" value="{number}"/>' for number, word in enumerate(words))
    return f'<EnumerationDomain name="enum">{entries}</EnumerationDomain>'


@smproxy.filter(name="LoopmendFillHoles", label="Fill Holes (Loopmend)")
@smproperty.input(name="Input", port_index=0)
@smdomain.datatype(dataTypes=["vtkPolyData"], composite_data_supported=False)
@smhint.xml('<ShowInMenu category="Loopmend"/>')
class LoopmendFillHoles(VTKPythonAlgorithmBase):
    """The surface with its holes filled. Its arrays run on over the patches; the array "loopmend hole" of the cells is the number of
    the hole, 0 for cells that were given."""

    def __init__(self):
        super().__init__(nInputPorts=1, nOutputPorts=1, inputType="vtkPolyData", outputType="vtkPolyData")
        self._options = {"density": 1.0, "continuity": "curvature", "boundary": "auto", "include_outer_rim": False}
        self._most_edges = 0
        self.result = None

    def _set(self, name, value):
        if self._options[name] != value:
            self._options[name] = value
            self.Modified()

    @smproperty.doublevector(name="Density", default_values=1.0)
    @smdomain.doublerange(min=0.1, max=10)
    def SetDensity(self, value):
        self._set("density", float(value))

    @smproperty.xml(f'<IntVectorProperty name="Continuity" command="SetContinuity" number_of_elements="1" default_values="2">{enumeration(CONTINUITY)}'
                    '</IntVectorProperty>')
    def SetContinuity(self, number):
        self._set("continuity", CONTINUITY[number])

    @smproperty.xml(f'<IntVectorProperty name="Boundary" command="SetBoundary" number_of_elements="1" default_values="0">{enumeration(BOUNDARY)}'
                    '</IntVectorProperty>')
    def SetBoundary(self, number):
        self._set("boundary", BOUNDARY[number])

    @smproperty.xml('<IntVectorProperty name="OuterRims" label="Outer rims" command="SetOuterRims" number_of_elements="1" default_values="0">'
                    '<BooleanDomain name="bool"/></IntVectorProperty>')
    def SetOuterRims(self, on):
        self._set("include_outer_rim", bool(on))

    @smproperty.intvector(name="MostEdges", label="Most edges of a hole (0: any)", default_values=0)
    def SetMostEdges(self, count):
        if self._most_edges != count:
            self._most_edges = int(count)
            self.Modified()

    def RequestData(self, _request, inputs, outputs):
        import loopmend  # here, so that ParaView can load this file and name what is missing

        given, output = vtkPolyData.GetData(inputs[0], 0), vtkPolyData.GetData(outputs, 0)

        def progress(done, total, _number):
            self.UpdateProgress(done / max(total, 1))
            if self.GetAbortExecute():
                raise InterruptedError

        try:
            if not loopmend.boundary_loops(given):
                output.ShallowCopy(given)
                return 1
            self.result = loopmend.fill(given, max_edges=self._most_edges or None, progress=progress, **self._options)
        except InterruptedError:
            return 0
        except loopmend.Error as error:
            print(f"Loopmend: {error}")  # ParaView shows it in its output messages
            return 0
        output.ShallowCopy(self.result.mesh)
        output.GetCellData().AddArray(self._hole_numbers())
        for hole in self.result.holes:
            if hole.message:
                print(f"Loopmend: loop {hole.number}: {hole.message}")
        return 1

    def _hole_numbers(self):
        import numpy as np
        from vtkmodules.util.numpy_support import numpy_to_vtk

        numbers = np.zeros(len(self.result.faces), np.int32)
        for hole in self.result.holes:
            numbers[hole.new_faces] = hole.number
        array = numpy_to_vtk(numbers, deep=True)
        array.SetName("loopmend hole")
        return array
