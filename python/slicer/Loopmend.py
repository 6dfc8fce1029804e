# SPDX-License-Identifier: GPL-3.0-or-later
"""A scripted module for 3D Slicer: fills the holes of a model into another model. Edit > Application Settings > Modules > Additional
module paths: the folder of this file. The Python module loopmend is installed once from Slicer's Python console: see
docs/user/paraview_and_slicer.md.
"""
import ctk
import qt
import slicer
from slicer.ScriptedLoadableModule import ScriptedLoadableModule, ScriptedLoadableModuleLogic, ScriptedLoadableModuleWidget


class Loopmend(ScriptedLoadableModule):
    """What the list of modules shows."""

    def __init__(self, parent):
        ScriptedLoadableModule.__init__(self, parent)
        parent.title = "Loopmend"
        parent.categories = ["Surface Models"]
        parent.dependencies = []
        parent.contributors = ["The Loopmend contributors"]
        parent.helpText = "Fills the holes of a model with patches whose curvature runs through the seam."
        parent.acknowledgementText = ""


class LoopmendWidget(ScriptedLoadableModuleWidget):
    """The panel: model, options, and a button."""

    def setup(self):
        ScriptedLoadableModuleWidget.setup(self)
        box = ctk.ctkCollapsibleButton()
        box.text = "Fill holes"
        self.layout.addWidget(box)
        form = qt.QFormLayout(box)
        self.model = slicer.qMRMLNodeComboBox()
        self.model.nodeTypes = ["vtkMRMLModelNode"]
        self.model.addEnabled = False
        self.model.setMRMLScene(slicer.mrmlScene)
        self.density = ctk.ctkSliderWidget()
        self.density.minimum, self.density.maximum, self.density.singleStep, self.density.value = 0.1, 10, 0.1, 1
        self.most_edges = qt.QSpinBox()
        self.most_edges.maximum = 1000000
        self.most_edges.specialValueText = "any"
        self.outer_rims = qt.QCheckBox()
        for label, widget in (("Model", self.model), ("Density", self.density), ("Most edges of a hole", self.most_edges),
                              ("Outer rims", self.outer_rims)):
            form.addRow(label, widget)
        button = qt.QPushButton("Fill")
        button.connect("clicked(bool)", self.onFill)
        form.addRow(button)
        self.layout.addStretch(1)

    def onFill(self, *_):
        model = self.model.currentNode()
        if model is None:
            slicer.util.warningDisplay("Choose a model first.")
            return
        with slicer.util.tryWithErrorDisplay("The holes were not filled.", waitCursor=True):
            said = LoopmendLogic().fill_model(model, density=self.density.value, max_edges=self.most_edges.value or None,
                                              include_outer_rim=self.outer_rims.checked)
            slicer.util.infoDisplay(said)


class LoopmendLogic(ScriptedLoadableModuleLogic):
    """Without the panel, for scripts: LoopmendLogic().fill_model(node)."""

    def fill_model(self, model, **options):
        """Adds a model with the name of the given one and "filled"; says in a sentence what became of the holes."""
        filled, said = self.fill_polydata(model.GetPolyData(), **options)
        node = slicer.modules.models.logic().AddModel(filled)
        node.SetName(f"{model.GetName()} filled")
        model.GetDisplayNode().SetVisibility(False)
        return said

    def fill_polydata(self, polydata, **options):
        """The filled vtkPolyData, with its arrays continued, and the sentence."""
        import loopmend  # here: Slicer loads this file before the package is installed

        result = loopmend.fill(polydata, **options)
        said = f"{sum(hole.is_filled for hole in result.holes)} of {len(result.holes)} boundary loops filled."
        remarks = [f"Loop {hole.number}: {text}" for hole in result.holes
                   for text in (hole.message, hole.verdict.sentence if hole.verdict else "") if text]
        return result.mesh, "\n".join([said, *remarks])
