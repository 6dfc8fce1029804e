<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
    <context>
        <name>loopmend</name>
        <message>
            <source>Reading the file</source>
            <translation>Reading the file</translation>
        </message>
        <message>
            <source>Sample</source>
            <translation>Sample</translation>
        </message>
        <message>
            <source>Looking for holes</source>
            <translation>Looking for holes</translation>
        </message>
        <message>
            <source>not known</source>
            <translation>not known</translation>
        </message>
        <message>
            <source>Patch of %1</source>
            <translation>Patch of %1</translation>
        </message>
        <message>
            <source>, vertex %1</source>
            <translation>, vertex %1</translation>
        </message>
        <message>
            <source>%1 has patches: export it by itself as %2 before you use the command.</source>
            <translation>%1 has patches: export it by itself as %2 before you use the command.</translation>
        </message>
        <message>
            <source>%1 was made in the window: export it by itself as %2 before you use the command.</source>
            <translation>%1 was made in the window: export it by itself as %2 before you use the command.</translation>
        </message>
        <message>
            <source>Its rims have other numbers then: 'loopmend info' tells them.</source>
            <translation>Its rims have other numbers then: 'loopmend info' tells them.</translation>
        </message>
        <message>
            <source>%1 was made in the window: export it as surface.ply, without patches, before you use the command.</source>
            <translation>%1 was made in the window: export it as surface.ply, without patches, before you use the command.</translation>
        </message>
        <message>
            <source>The command compares on all holes of the file, and on nothing else.</source>
            <translation>The command compares on all holes of the file, and on nothing else.</translation>
        </message>
        <message>
            <source>The command runs all four flows.</source>
            <translation>The command runs all four flows.</translation>
        </message>
        <message>
            <source>The command line is in the clipboard.</source>
            <translation>The command line is in the clipboard.</translation>
        </message>
        <message>
            <source>Flow</source>
            <translation>Flow</translation>
        </message>
        <message>
            <source>Boundary</source>
            <translation>Boundary</translation>
        </message>
        <message>
            <source>How far MMCVF trusts the curvature of the scan around the hole</source>
            <translation>How far MMCVF trusts the curvature of the scan around the hole</translation>
        </message>
        <message>
            <source>Auto</source>
            <translation>Auto</translation>
        </message>
        <message>
            <source>As far as it can be trusted: the flow on smooth scans, robust fairing on rough ones.</source>
            <translation>As far as it can be trusted: the flow on smooth scans, robust fairing on rough ones.</translation>
        </message>
        <message>
            <source>Exact</source>
            <translation>Exact</translation>
        </message>
        <message>
            <source>As it is: the flow itself, also on rough scans.</source>
            <translation>As it is: the flow itself, also on rough scans.</translation>
        </message>
        <message>
            <source>Robust</source>
            <translation>Robust</translation>
        </message>
        <message>
            <source>Hardly: robust fairing in place of the flow.</source>
            <translation>Hardly: robust fairing in place of the flow.</translation>
        </message>
        <message>
            <source>Continuity</source>
            <translation>Continuity</translation>
        </message>
        <message>
            <source>What MMCVF makes run through the seam</source>
            <translation>What MMCVF makes run through the seam</translation>
        </message>
        <message>
            <source>Curvature</source>
            <translation>Curvature</translation>
        </message>
        <message>
            <source>Position, tangent and curvature: the flow itself.</source>
            <translation>Position, tangent and curvature: the flow itself.</translation>
        </message>
        <message>
            <source>Tangent</source>
            <translation>Tangent</translation>
        </message>
        <message>
            <source>Position and tangent: linear fairing in place of the flow.</source>
            <translation>Position and tangent: linear fairing in place of the flow.</translation>
        </message>
        <message>
            <source>Position</source>
            <translation>Position</translation>
        </message>
        <message>
            <source>Position alone: a taut skin, with a crease at the seam.</source>
            <translation>Position alone: a taut skin, with a crease at the seam.</translation>
        </message>
        <message>
            <source>Shading</source>
            <translation>Shading</translation>
        </message>
        <message>
            <source>Mean curvature H</source>
            <translation>Mean curvature H</translation>
        </message>
        <message>
            <source>Gaussian curvature K</source>
            <translation>Gaussian curvature K</translation>
        </message>
        <message>
            <source>Plain</source>
            <translation>Plain</translation>
        </message>
        <message>
            <source>Zebra</source>
            <translation>Zebra</translation>
        </message>
        <message>
            <source>Isophotes</source>
            <translation>Isophotes</translation>
        </message>
    </context>
    <context>
        <name>loopmend::About</name>
        <message>
            <source>About Loopmend</source>
            <translation>About Loopmend</translation>
        </message>
        <message>
            <source>&lt;h2&gt;Loopmend %1&lt;/h2&gt;&lt;p&gt;Closes holes in scanned meshes with patches whose curvature runs through the seam.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later: you may use, study, share and change it. It comes without any warranty.&lt;br&gt;&lt;a href="https://www.gnu.org/licenses/gpl-3.0.html"&gt;gnu.org/licenses/gpl-3.0&lt;/a&gt;&lt;/p&gt;&lt;p&gt;Built with Qt, VTK, QCustomPlot, Eigen, OpenMesh, CGAL and SuiteSparse.&lt;/p&gt;</source>
            <translation>&lt;h2&gt;Loopmend %1&lt;/h2&gt;&lt;p&gt;Closes holes in scanned meshes with patches whose curvature runs through the seam.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later: you may use, study, share and change it. It comes without any warranty.&lt;br&gt;&lt;a href="https://www.gnu.org/licenses/gpl-3.0.html"&gt;gnu.org/licenses/gpl-3.0&lt;/a&gt;&lt;/p&gt;&lt;p&gt;Built with Qt, VTK, QCustomPlot, Eigen, OpenMesh, CGAL and SuiteSparse.&lt;/p&gt;</translation>
        </message>
    </context>
    <context>
        <name>loopmend::Autosave</name>
        <message>
            <source>The copy that would survive a crash could not be written: %1</source>
            <translation>The copy that would survive a crash could not be written: %1</translation>
        </message>
        <message>
            <source>Sample</source>
            <translation>Sample</translation>
        </message>
        <message numerus="yes">
            <source>%1, %n patch(es), %2</source>
            <translation>
                <numerusform>%1, %n patch, %2</numerusform>
                <numerusform>%1, %n patches, %2</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>loopmend::Banner</name>
        <message>
            <source>Close</source>
            <translation>Close</translation>
        </message>
        <message>
            <source>Close this message (Esc)</source>
            <translation>Close this message (Esc)</translation>
        </message>
    </context>
    <context>
        <name>loopmend::BlendBox</name>
        <message>
            <source>Those that &amp;face each other</source>
            <translation>Those that &amp;face each other</translation>
        </message>
        <message>
            <source>Select of each part the loop that looks at the others most</source>
            <translation>Select of each part the loop that looks at the others most</translation>
        </message>
        <message>
            <source>Select two or more rims, in the picture or in the table; Ctrl adds. One patch will join them.</source>
            <translation>Select two or more rims, in the picture or in the table; Ctrl adds. One patch will join them.</translation>
        </message>
        <message>
            <source>Density</source>
            <translation>Density</translation>
        </message>
        <message>
            <source>Edges along a length, relative to the surroundings</source>
            <translation>Edges along a length, relative to the surroundings</translation>
        </message>
        <message>
            <source>Part to place</source>
            <translation>Part to place</translation>
        </message>
        <message>
            <source>This part gets a handle in the picture: arrows move it, rings turn it, the square scales it</source>
            <translation>This part gets a handle in the picture: arrows move it, rings turn it, the square scales it</translation>
        </message>
        <message>
            <source>&amp;Density</source>
            <translation>&amp;Density</translation>
        </message>
        <message>
            <source>&amp;Place</source>
            <translation>&amp;Place</translation>
        </message>
        <message>
            <source>no part</source>
            <translation>no part</translation>
        </message>
        <message>
            <source>Open the parts first.</source>
            <translation>Open the parts first.</translation>
        </message>
        <message>
            <source>Only holes and outer rims can be joined, not a loop of the kind: %1.</source>
            <translation>Only holes and outer rims can be joined, not a loop of the kind: %1.</translation>
        </message>
        <message>
            <source>A selected hole is filled: reject its patch first.</source>
            <translation>A selected hole is filled: reject its patch first.</translation>
        </message>
        <message>
            <source>Select at least two rims.</source>
            <translation>Select at least two rims.</translation>
        </message>
        <message>
            <source>No rim is selected.</source>
            <translation>No rim is selected.</translation>
        </message>
        <message>
            <source>Selected: %1</source>
            <translation>Selected: %1</translation>
        </message>
    </context>
    <context>
        <name>loopmend::CompareDesk</name>
        <message>
            <source>There is no hole to compare flows on. Open a scan with holes, or pose a region, points or a bridge.</source>
            <translation>There is no hole to compare flows on. Open a scan with holes, or pose a region, points or a bridge.</translation>
        </message>
        <message>
            <source>The holes belong to several scans. Select holes of one of them.</source>
            <translation>The holes belong to several scans. Select holes of one of them.</translation>
        </message>
        <message>
            <source>%1 of %2</source>
            <translation>%1 of %2</translation>
        </message>
        <message>
            <source>Put this patch into the holes, in place of what is there; can be undone</source>
            <translation>Put this patch into the holes, in place of what is there; can be undone</translation>
        </message>
        <message>
            <source>The scan of this comparison is no longer open.</source>
            <translation>The scan of this comparison is no longer open.</translation>
        </message>
        <message>
            <source>The main window is busy. Try again when it is done.</source>
            <translation>The main window is busy. Try again when it is done.</translation>
        </message>
        <message>
            <source>%1 was taken over into the main window; Ctrl+Z there takes it back.</source>
            <translation>%1 was taken over into the main window; Ctrl+Z there takes it back.</translation>
        </message>
        <message>
            <source>Take this surface over into the document, in place of what it came from; can be undone</source>
            <translation>Take this surface over into the document, in place of what it came from; can be undone</translation>
        </message>
    </context>
    <context>
        <name>loopmend::CompareNumbers</name>
        <message>
            <source>Surface</source>
            <translation>Surface</translation>
        </message>
        <message>
            <source>End</source>
            <translation>End</translation>
        </message>
        <message>
            <source>Steps</source>
            <translation>Steps</translation>
        </message>
        <message>
            <source>∫|∇H|²</source>
            <translation>∫|∇H|²</translation>
        </message>
        <message>
            <source>∫H²</source>
            <translation>∫H²</translation>
        </message>
        <message>
            <source>Area</source>
            <translation>Area</translation>
        </message>
        <message>
            <source>Wide jump</source>
            <translation>Wide jump</translation>
        </message>
        <message>
            <source>Jump of H</source>
            <translation>Jump of H</translation>
        </message>
        <message>
            <source>× diam.</source>
            <translation>× diam.</translation>
        </message>
        <message>
            <source>Angle, °</source>
            <translation>Angle, °</translation>
        </message>
        <message>
            <source>Folds</source>
            <translation>Folds</translation>
        </message>
        <message>
            <source>Cuts</source>
            <translation>Cuts</translation>
        </message>
        <message>
            <source>Which flow</source>
            <translation>Which flow</translation>
        </message>
        <message>
            <source>How the flow ended</source>
            <translation>How the flow ended</translation>
        </message>
        <message>
            <source>Accepted steps</source>
            <translation>Accepted steps</translation>
        </message>
        <message>
            <source>What MMCVF lowers, in 1/length²</source>
            <translation>What MMCVF lowers, in 1/length²</translation>
        </message>
        <message>
            <source>What WF lowers, without a unit</source>
            <translation>What WF lowers, without a unit</translation>
        </message>
        <message>
            <source>What MCF and SDF lower, in length²</source>
            <translation>What MCF and SDF lower, in length²</translation>
        </message>
        <message>
            <source>Jump of H across the seam from wide one-sided fits, rms, in 1/length: the fairest figure between flows</source>
            <translation>Jump of H across the seam from wide one-sided fits, rms, in 1/length: the fairest figure between flows</translation>
        </message>
        <message>
            <source>Jump of H across the seam from narrow one-sided fits, rms, in 1/length</source>
            <translation>Jump of H across the seam from narrow one-sided fits, rms, in 1/length</translation>
        </message>
        <message>
            <source>The jump of H times the hole's diameter: without a unit</source>
            <translation>The jump of H times the hole's diameter: without a unit</translation>
        </message>
        <message>
            <source>Angle between the normals of both sides at the seam, rms, in degrees</source>
            <translation>Angle between the normals of both sides at the seam, rms, in degrees</translation>
        </message>
        <message>
            <source>Edges folded by more than 90°</source>
            <translation>Edges folded by more than 90°</translation>
        </message>
        <message>
            <source>Places where the patch cuts itself or its surroundings</source>
            <translation>Places where the patch cuts itself or its surroundings</translation>
        </message>
        <message>
            <source>step limit</source>
            <translation>step limit</translation>
        </message>
        <message>
            <source>stopped early</source>
            <translation>stopped early</translation>
        </message>
        <message>
            <source>Energy of each flow against the step</source>
            <translation>Energy of each flow against the step</translation>
        </message>
        <message>
            <source>Mean curvature across the seam, one line for each flow</source>
            <translation>Mean curvature across the seam, one line for each flow</translation>
        </message>
        <message>
            <source>Figures of all flows</source>
            <translation>Figures of all flows</translation>
        </message>
        <message>
            <source>Which energy</source>
            <translation>Which energy</translation>
        </message>
        <message>
            <source>Which energy the plot shows; each flow lowers its own</source>
            <translation>Which energy the plot shows; each flow lowers its own</translation>
        </message>
        <message>
            <source>∫|∇H|², what MMCVF lowers</source>
            <translation>∫|∇H|², what MMCVF lowers</translation>
        </message>
        <message>
            <source>∫H², what WF lowers</source>
            <translation>∫H², what WF lowers</translation>
        </message>
        <message>
            <source>Area, what MCF and SDF lower</source>
            <translation>Area, what MCF and SDF lower</translation>
        </message>
        <message>
            <source>H across the seam, patch right of 0</source>
            <translation>H across the seam, patch right of 0</translation>
        </message>
        <message>
            <source>Start</source>
            <translation>Start</translation>
        </message>
        <message>
            <source>Run the flows, and their energies are drawn here.</source>
            <translation>Run the flows, and their energies are drawn here.</translation>
        </message>
        <message>
            <source>There is no seam to look across.</source>
            <translation>There is no seam to look across.</translation>
        </message>
        <message>
            <source>converged</source>
            <translation>converged</translation>
        </message>
        <message>
            <source>faired</source>
            <translation>faired</translation>
        </message>
    </context>
    <context>
        <name>loopmend::CompareWindow</name>
        <message>
            <source>Wrote %1, and beside it energies and profile.</source>
            <translation>Wrote %1, and beside it energies and profile.</translation>
        </message>
        <message>
            <source>Wrote %1.</source>
            <translation>Wrote %1.</translation>
        </message>
        <message>
            <source>Save numbers</source>
            <translation>Save numbers</translation>
        </message>
        <message>
            <source>CSV (*.csv)</source>
            <translation>CSV (*.csv)</translation>
        </message>
        <message>
            <source>Compare flows: %1</source>
            <translation>Compare flows: %1</translation>
        </message>
        <message>
            <source>&amp;Run all</source>
            <translation>&amp;Run all</translation>
        </message>
        <message>
            <source>All flows from the same start, side by side (Space)</source>
            <translation>All flows from the same start, side by side (Space)</translation>
        </message>
        <message>
            <source>&amp;Stop</source>
            <translation>&amp;Stop</translation>
        </message>
        <message>
            <source>Stop at once; what was reached stays (Esc)</source>
            <translation>Stop at once; what was reached stays (Esc)</translation>
        </message>
        <message>
            <source>Number of views</source>
            <translation>Number of views</translation>
        </message>
        <message>
            <source>How many flows are compared</source>
            <translation>How many flows are compared</translation>
        </message>
        <message>
            <source>%1 views</source>
            <translation>%1 views</translation>
        </message>
        <message>
            <source>To the steady state</source>
            <translation>To the steady state</translation>
        </message>
        <message>
            <source>Step by step</source>
            <translation>Step by step</translation>
        </message>
        <message>
            <source>How</source>
            <translation>How</translation>
        </message>
        <message>
            <source>Straight to where each flow comes to rest, or in time steps, as in the paper</source>
            <translation>Straight to where each flow comes to rest, or in time steps, as in the paper</translation>
        </message>
        <message>
            <source>Time step</source>
            <translation>Time step</translation>
        </message>
        <message>
            <source>Time step σ, without a unit; the same for all flows</source>
            <translation>Time step σ, without a unit; the same for all flows</translation>
        </message>
        <message>
            <source>Save &amp;picture…</source>
            <translation>Save &amp;picture…</translation>
        </message>
        <message>
            <source>All views as one PNG of a size you choose</source>
            <translation>All views as one PNG of a size you choose</translation>
        </message>
        <message>
            <source>Save &amp;numbers…</source>
            <translation>Save &amp;numbers…</translation>
        </message>
        <message>
            <source>Table, energies and profiles as CSV, as loopmend compare writes them</source>
            <translation>Table, energies and profiles as CSV, as loopmend compare writes them</translation>
        </message>
        <message>
            <source>How all views are shown (keys 1 to 5)</source>
            <translation>How all views are shown (keys 1 to 5)</translation>
        </message>
        <message>
            <source>&amp;Wireframe</source>
            <translation>&amp;Wireframe</translation>
        </message>
        <message>
            <source>Wireframe</source>
            <translation>Wireframe</translation>
        </message>
        <message>
            <source>Draw the triangles' edges</source>
            <translation>Draw the triangles' edges</translation>
        </message>
        <message>
            <source>C&amp;olours ±</source>
            <translation>C&amp;olours ±</translation>
        </message>
        <message>
            <source>Own range of colours</source>
            <translation>Own range of colours</translation>
        </message>
        <message>
            <source>A colour range of your own, instead of that of the surroundings</source>
            <translation>A colour range of your own, instead of that of the surroundings</translation>
        </message>
        <message>
            <source>Range</source>
            <translation>Range</translation>
        </message>
        <message>
            <source>The curvature at the ends of the colours</source>
            <translation>The curvature at the ends of the colours</translation>
        </message>
        <message>
            <source>&amp;Link views</source>
            <translation>&amp;Link views</translation>
        </message>
        <message>
            <source>Link views</source>
            <translation>Link views</translation>
        </message>
        <message>
            <source>Turning one view turns all</source>
            <translation>Turning one view turns all</translation>
        </message>
        <message>
            <source>&amp;Frame</source>
            <translation>&amp;Frame</translation>
        </message>
        <message>
            <source>See the whole patch in every view (F)</source>
            <translation>See the whole patch in every view (F)</translation>
        </message>
        <message>
            <source>Wip&amp;e between</source>
            <translation>Wip&amp;e between</translation>
        </message>
        <message>
            <source>Wipe</source>
            <translation>Wipe</translation>
        </message>
        <message>
            <source>One large picture of two flows, with a line between them that can be drawn</source>
            <translation>One large picture of two flows, with a line between them that can be drawn</translation>
        </message>
        <message>
            <source>Left of the line</source>
            <translation>Left of the line</translation>
        </message>
        <message>
            <source>Which flow, or the start, is left of the line</source>
            <translation>Which flow, or the start, is left of the line</translation>
        </message>
        <message>
            <source>Right of the line</source>
            <translation>Right of the line</translation>
        </message>
        <message>
            <source>Which flow, or the start, is right of the line</source>
            <translation>Which flow, or the start, is right of the line</translation>
        </message>
        <message>
            <source>Start</source>
            <translation>Start</translation>
        </message>
        <message>
            <source>σ = %1</source>
            <translation>σ = %1</translation>
        </message>
        <message>
            <source>Making the start…</source>
            <translation>Making the start…</translation>
        </message>
        <message>
            <source>Running…</source>
            <translation>Running…</translation>
        </message>
        <message>
            <source>%1 free vertices</source>
            <translation>%1 free vertices</translation>
        </message>
        <message>
            <source>Copy co&amp;mmand line</source>
            <translation>Copy co&amp;mmand line</translation>
        </message>
        <message>
            <source>Copy the commands that do the same</source>
            <translation>Copy the commands that do the same</translation>
        </message>
    </context>
    <context>
        <name>loopmend::DecisionBox</name>
        <message>
            <source>the filler</source>
            <translation>the filler</translation>
        </message>
        <message>
            <source>3  Look back, decide</source>
            <translation>3  Look back, decide</translation>
        </message>
        <message>
            <source>Timeline</source>
            <translation>Timeline</translation>
        </message>
        <message>
            <source>Go back to any recorded state, from the filler on the left to the latest</source>
            <translation>Go back to any recorded state, from the filler on the left to the latest</translation>
        </message>
        <message>
            <source>&amp;Accept</source>
            <translation>&amp;Accept</translation>
        </message>
        <message>
            <source>Keep this patch as it is; no flow moves it any more (A)</source>
            <translation>Keep this patch as it is; no flow moves it any more (A)</translation>
        </message>
        <message>
            <source>R&amp;eject</source>
            <translation>R&amp;eject</translation>
        </message>
        <message>
            <source>Throw this patch away; the hole is open again (Delete)</source>
            <translation>Throw this patch away; the hole is open again (Delete)</translation>
        </message>
        <message>
            <source>&amp;Copy command line</source>
            <translation>&amp;Copy command line</translation>
        </message>
        <message>
            <source>Copy the commands that fill these holes in just this way, for a terminal or a script</source>
            <translation>Copy the commands that fill these holes in just this way, for a terminal or a script</translation>
        </message>
        <message>
            <source>Recorded states appear here.</source>
            <translation>Recorded states appear here.</translation>
        </message>
        <message>
            <source>State %1 of %2: %3</source>
            <translation>State %1 of %2: %3</translation>
        </message>
        <message>
            <source>&amp;Open again</source>
            <translation>&amp;Open again</translation>
        </message>
        <message>
            <source>Open again</source>
            <translation>Open again</translation>
        </message>
        <message>
            <source>Accept</source>
            <translation>Accept</translation>
        </message>
        <message>
            <source>Let a flow move this patch again (A)</source>
            <translation>Let a flow move this patch again (A)</translation>
        </message>
        <message>
            <source>step %1</source>
            <translation>step %1</translation>
        </message>
    </context>
    <context>
        <name>loopmend::EnergyView</name>
        <message>
            <source>Energy ∫|∇H|², 1/length²</source>
            <translation>Energy ∫|∇H|², 1/length²</translation>
        </message>
        <message>
            <source>Energy ∫H²</source>
            <translation>Energy ∫H²</translation>
        </message>
        <message>
            <source>Area, length²</source>
            <translation>Area, length²</translation>
        </message>
        <message>
            <source>Energy and residual against the step</source>
            <translation>Energy and residual against the step</translation>
        </message>
        <message>
            <source>Energy</source>
            <translation>Energy</translation>
        </message>
        <message>
            <source>Run a flow, and its energy is drawn here.</source>
            <translation>Run a flow, and its energy is drawn here.</translation>
        </message>
        <message>
            <source>Residual, edge lengths (right)</source>
            <translation>Residual, edge lengths (right)</translation>
        </message>
    </context>
    <context>
        <name>loopmend::ExampleDesk</name>
        <message>
            <source>%1 %2</source>
            <translation>%1 %2</translation>
        </message>
        <message>
            <source>%1 of the paper: %2.</source>
            <translation>%1 of the paper: %2.</translation>
        </message>
        <message>
            <source>&amp;Run it</source>
            <translation>&amp;Run it</translation>
        </message>
    </context>
    <context>
        <name>loopmend::FileDesk</name>
        <message>
            <source>&amp;Save session</source>
            <translation>&amp;Save session</translation>
        </message>
        <message>
            <source>&amp;Cancel</source>
            <translation>&amp;Cancel</translation>
        </message>
        <message>
            <source>&amp;Open without saving</source>
            <translation>&amp;Open without saving</translation>
        </message>
        <message>
            <source>Add scans to the scene</source>
            <translation>Add scans to the scene</translation>
        </message>
        <message>
            <source>Open</source>
            <translation>Open</translation>
        </message>
        <message>
            <source>Scans and sessions (*.ply *.stl *.obj *.off *.loopmend *.PLY *.STL *.OBJ *.OFF);;All files (*)</source>
            <translation>Scans and sessions (*.ply *.stl *.obj *.off *.loopmend *.PLY *.STL *.OBJ *.OFF);;All files (*)</translation>
        </message>
        <message>
            <source>Export</source>
            <translation>Export</translation>
        </message>
        <message>
            <source>PLY, exact (*.ply);;STL (*.stl);;OBJ (*.obj);;OFF (*.off)</source>
            <translation>PLY, exact (*.ply);;STL (*.stl);;OBJ (*.obj);;OFF (*.off)</translation>
        </message>
        <message>
            <source>Save session</source>
            <translation>Save session</translation>
        </message>
        <message>
            <source>Loopmend session (*.loopmend)</source>
            <translation>Loopmend session (*.loopmend)</translation>
        </message>
        <message>
            <source>&amp;Close without saving</source>
            <translation>&amp;Close without saving</translation>
        </message>
        <message>
            <source>Loopmend ended unexpectedly. Work was kept: %1.</source>
            <translation>Loopmend ended unexpectedly. Work was kept: %1.</translation>
        </message>
        <message>
            <source>&amp;Recover</source>
            <translation>&amp;Recover</translation>
        </message>
        <message>
            <source>recovered work</source>
            <translation>recovered work</translation>
        </message>
        <message>
            <source>&amp;Discard</source>
            <translation>&amp;Discard</translation>
        </message>
        <message>
            <source>&amp;Later</source>
            <translation>&amp;Later</translation>
        </message>
        <message>
            <source>&amp;%1  %2</source>
            <translation>&amp;%1  %2</translation>
        </message>
        <message>
            <source>Nothing yet</source>
            <translation>Nothing yet</translation>
        </message>
        <message>
            <source>&amp;Forget these</source>
            <translation>&amp;Forget these</translation>
        </message>
        <message>
            <source>Nothing is open</source>
            <translation>Nothing is open</translation>
        </message>
        <message>
            <source>There is work that is neither saved nor exported.</source>
            <translation>There is work that is neither saved nor exported.</translation>
        </message>
    </context>
    <context>
        <name>loopmend::FillBox</name>
        <message>
            <source>1  Fill</source>
            <translation>1  Fill</translation>
        </message>
        <message>
            <source>Density</source>
            <translation>Density</translation>
        </message>
        <message>
            <source>Density of the patch relative to the scan around it; 2 halves the edge length</source>
            <translation>Density of the patch relative to the scan around it; 2 halves the edge length</translation>
        </message>
        <message>
            <source>&amp;Density</source>
            <translation>&amp;Density</translation>
        </message>
        <message>
            <source>Pre&amp;view</source>
            <translation>Pre&amp;view</translation>
        </message>
        <message>
            <source>Preview</source>
            <translation>Preview</translation>
        </message>
        <message>
            <source>&amp;Fill</source>
            <translation>&amp;Fill</translation>
        </message>
        <message>
            <source>Close the selected holes, or all holes when none is selected (Ctrl+F)</source>
            <translation>Close the selected holes, or all holes when none is selected (Ctrl+F)</translation>
        </message>
        <message>
            <source>Open a scan first.</source>
            <translation>Open a scan first.</translation>
        </message>
        <message>
            <source>%1, selected</source>
            <translation>%1, selected</translation>
        </message>
        <message>
            <source>All open holes (%1)</source>
            <translation>All open holes (%1)</translation>
        </message>
        <message>
            <source>The selection is filled already.</source>
            <translation>The selection is filled already.</translation>
        </message>
        <message>
            <source>No open hole is left. To fill a loop that is left out, select it.</source>
            <translation>No open hole is left. To fill a loop that is left out, select it.</translation>
        </message>
        <message>
            <source>No open hole is left.</source>
            <translation>No open hole is left.</translation>
        </message>
        <message>
            <source>%1 to %2</source>
            <translation>%1 to %2</translation>
        </message>
        <message>
            <source>About %1 triangles, edges of %2.</source>
            <translation>About %1 triangles, edges of %2.</translation>
        </message>
        <message>
            <source>Show the patch with its edges before it is made; for up to 200 holes at once</source>
            <translation>Show the patch with its edges before it is made; for up to 200 holes at once</translation>
        </message>
    </context>
    <context>
        <name>loopmend::FlowBox</name>
        <message>
            <source>2  Smooth by a flow</source>
            <translation>2  Smooth by a flow</translation>
        </message>
        <message>
            <source>Which geometric flow moves the patch, and so how far the seam is matched</source>
            <translation>Which geometric flow moves the patch, and so how far the seam is matched</translation>
        </message>
        <message>
            <source>&amp;To steady state</source>
            <translation>&amp;To steady state</translation>
        </message>
        <message>
            <source>Time step</source>
            <translation>Time step</translation>
        </message>
        <message>
            <source>Time step σ of Step and Run, without a unit: 1 is one decay time of the slowest wave on this patch</source>
            <translation>Time step σ of Step and Run, without a unit: 1 is one decay time of the slowest wave on this patch</translation>
        </message>
        <message>
            <source>Time ste&amp;p</source>
            <translation>Time ste&amp;p</translation>
        </message>
        <message>
            <source>&amp;Step</source>
            <translation>&amp;Step</translation>
        </message>
        <message>
            <source>Take one time step (S)</source>
            <translation>Take one time step (S)</translation>
        </message>
        <message>
            <source>&amp;Run</source>
            <translation>&amp;Run</translation>
        </message>
        <message>
            <source>Accepted already. Open it again to go on.</source>
            <translation>Accepted already. Open it again to go on.</translation>
        </message>
        <message>
            <source>The selection is not filled yet.</source>
            <translation>The selection is not filled yet.</translation>
        </message>
        <message>
            <source>Nothing is filled yet.</source>
            <translation>Nothing is filled yet.</translation>
        </message>
        <message>
            <source>σ = %1</source>
            <translation>σ = %1</translation>
        </message>
        <message>
            <source>Pau&amp;se</source>
            <translation>Pau&amp;se</translation>
        </message>
        <message>
            <source>Pausing…</source>
            <translation>Pausing…</translation>
        </message>
        <message>
            <source>Compare &amp;flows…</source>
            <translation>Compare &amp;flows…</translation>
        </message>
        <message>
            <source>Two to four flows from one start, side by side, in a window of their own (C)</source>
            <translation>Two to four flows from one start, side by side, in a window of their own (C)</translation>
        </message>
        <message>
            <source>&amp;Boundary</source>
            <translation>&amp;Boundary</translation>
        </message>
        <message>
            <source>Continuit&amp;y</source>
            <translation>Continuit&amp;y</translation>
        </message>
        <message>
            <source>Go straight to where the flow converges (T)</source>
            <translation>Go straight to where the flow converges (T)</translation>
        </message>
        <message>
            <source>Take one time step after another until the flow converges (Space)</source>
            <translation>Take one time step after another until the flow converges (Space)</translation>
        </message>
    </context>
    <context>
        <name>loopmend::FlowPane</name>
        <message>
            <source>start</source>
            <translation>start</translation>
        </message>
        <message>
            <source>step %1</source>
            <translation>step %1</translation>
        </message>
        <message>
            <source>stopped at step %1</source>
            <translation>stopped at step %1</translation>
        </message>
        <message>
            <source>stopped early, step %1</source>
            <translation>stopped early, step %1</translation>
        </message>
        <message>
            <source>%1 steps</source>
            <translation>%1 steps</translation>
        </message>
        <message>
            <source>Accept</source>
            <translation>Accept</translation>
        </message>
        <message>
            <source>Take this result over into the document; can be undone</source>
            <translation>Take this result over into the document; can be undone</translation>
        </message>
        <message>
            <source>Flow</source>
            <translation>Flow</translation>
        </message>
        <message>
            <source>Which flow this view shows</source>
            <translation>Which flow this view shows</translation>
        </message>
        <message>
            <source> · ∫|∇H|² %1</source>
            <translation> · ∫|∇H|² %1</translation>
        </message>
        <message>
            <source>Energy ∫|∇H|² %1</source>
            <translation>Energy ∫|∇H|² %1</translation>
        </message>
        <message>
            <source> · %1° · ΔH %2</source>
            <translation> · %1° · ΔH %2</translation>
        </message>
        <message>
            <source>At the seam: angle %1° (rms), jump of H %2 (rms)</source>
            <translation>At the seam: angle %1° (rms), jump of H %2 (rms)</translation>
        </message>
        <message>
            <source>Run the flows first</source>
            <translation>Run the flows first</translation>
        </message>
        <message>
            <source>converged, %1 steps</source>
            <translation>converged, %1 steps</translation>
        </message>
        <message>
            <source>faired, %1 steps</source>
            <translation>faired, %1 steps</translation>
        </message>
    </context>
    <context>
        <name>loopmend::Gallery</name>
        <message>
            <source>Cylinder</source>
            <translation>Cylinder</translation>
        </message>
        <message>
            <source>Sphere</source>
            <translation>Sphere</translation>
        </message>
        <message>
            <source>Three tubes</source>
            <translation>Three tubes</translation>
        </message>
        <message>
            <source>Six tubes</source>
            <translation>Six tubes</translation>
        </message>
        <message>
            <source>T piece</source>
            <translation>T piece</translation>
        </message>
        <message>
            <source>Head</source>
            <translation>Head</translation>
        </message>
        <message>
            <source>Dodecahedron</source>
            <translation>Dodecahedron</translation>
        </message>
        <message>
            <source>Flows, tubes</source>
            <translation>Flows, tubes</translation>
        </message>
        <message>
            <source>Flows, graph</source>
            <translation>Flows, graph</translation>
        </message>
        <message>
            <source>A cylinder with parts missing</source>
            <translation>A cylinder with parts missing</translation>
        </message>
        <message>
            <source>A wire-frame of a sphere with eight openings</source>
            <translation>A wire-frame of a sphere with eight openings</translation>
        </message>
        <message>
            <source>Three tubes that form a T</source>
            <translation>Three tubes that form a T</translation>
        </message>
        <message>
            <source>A head-like mesh with holes in nose, face and jaw</source>
            <translation>A head-like mesh with holes in nose, face and jaw</translation>
        </message>
        <message>
            <source>A dodecahedron</source>
            <translation>A dodecahedron</translation>
        </message>
        <message>
            <source>MMCVF, SDF and WF on the six tubes</source>
            <translation>MMCVF, SDF and WF on the six tubes</translation>
        </message>
        <message>
            <source>The graph of a function: MCF, SDF, WF and MMCVF</source>
            <translation>The graph of a function: MCF, SDF, WF and MMCVF</translation>
        </message>
        <message>
            <source>%1: %2. A click opens it, a second one runs it</source>
            <translation>%1: %2. A click opens it, a second one runs it</translation>
        </message>
    </context>
    <context>
        <name>loopmend::HelpWindow</name>
        <message>
            <source>First steps</source>
            <translation>First steps</translation>
        </message>
        <message>
            <source>Holes</source>
            <translation>Holes</translation>
        </message>
        <message>
            <source>Patch and flow</source>
            <translation>Patch and flow</translation>
        </message>
        <message>
            <source>Looking at curvature</source>
            <translation>Looking at curvature</translation>
        </message>
        <message>
            <source>Inspecting the seam</source>
            <translation>Inspecting the seam</translation>
        </message>
        <message>
            <source>Files, sessions, recovery</source>
            <translation>Files, sessions, recovery</translation>
        </message>
        <message>
            <source>When something goes wrong</source>
            <translation>When something goes wrong</translation>
        </message>
        <message>
            <source>Help</source>
            <translation>Help</translation>
        </message>
        <message>
            <source>Pages</source>
            <translation>Pages</translation>
        </message>
        <message>
            <source>The pages of the help</source>
            <translation>The pages of the help</translation>
        </message>
        <message>
            <source>Page</source>
            <translation>Page</translation>
        </message>
        <message>
            <source>Compare, region, points, blend</source>
            <translation>Compare, region, points, blend</translation>
        </message>
    </context>
    <context>
        <name>loopmend::HoleTable</name>
        <message>
            <source>The loop's number within its scan, by falling perimeter</source>
            <translation>The loop's number within its scan, by falling perimeter</translation>
        </message>
        <message>
            <source>Number of edges along the rim</source>
            <translation>Number of edges along the rim</translation>
        </message>
        <message>
            <source>Largest distance between two rim vertices, in the scan's unit</source>
            <translation>Largest distance between two rim vertices, in the scan's unit</translation>
        </message>
        <message>
            <source>Length of the rim, in the scan's unit</source>
            <translation>Length of the rim, in the scan's unit</translation>
        </message>
        <message>
            <source>Area of the rim's projection to its best plane, in the scan's unit squared</source>
            <translation>Area of the rim's projection to its best plane, in the scan's unit squared</translation>
        </message>
        <message>
            <source>How far the rim leaves its best plane: rms distance divided by the diameter</source>
            <translation>How far the rim leaves its best plane: rms distance divided by the diameter</translation>
        </message>
        <message>
            <source>Hole, outer rim of a sheet, crack, ...</source>
            <translation>Hole, outer rim of a sheet, crack, ...</translation>
        </message>
        <message>
            <source>The file that the loop belongs to</source>
            <translation>The file that the loop belongs to</translation>
        </message>
        <message>
            <source>What has been done about it</source>
            <translation>What has been done about it</translation>
        </message>
        <message>
            <source>#</source>
            <translation>#</translation>
        </message>
        <message>
            <source>Edges</source>
            <translation>Edges</translation>
        </message>
        <message>
            <source>Diameter</source>
            <translation>Diameter</translation>
        </message>
        <message>
            <source>Perimeter</source>
            <translation>Perimeter</translation>
        </message>
        <message>
            <source>Area</source>
            <translation>Area</translation>
        </message>
        <message>
            <source>Planarity</source>
            <translation>Planarity</translation>
        </message>
        <message>
            <source>Kind</source>
            <translation>Kind</translation>
        </message>
        <message>
            <source>Scan</source>
            <translation>Scan</translation>
        </message>
        <message>
            <source>State</source>
            <translation>State</translation>
        </message>
        <message>
            <source>How far the scan around the hole can be trusted, known once the hole is filled: smooth, noisy or rough</source>
            <translation>How far the scan around the hole can be trusted, known once the hole is filled: smooth, noisy or rough</translation>
        </message>
        <message>
            <source>Rim</source>
            <translation>Rim</translation>
        </message>
    </context>
    <context>
        <name>loopmend::HolesPanel</name>
        <message>
            <source>Select &amp;all</source>
            <translation>Select &amp;all</translation>
        </message>
        <message>
            <source>Select every hole; rims, cracks and cuts are left out</source>
            <translation>Select every hole; rims, cracks and cuts are left out</translation>
        </message>
        <message>
            <source>Filter: number, kind, state</source>
            <translation>Filter: number, kind, state</translation>
        </message>
        <message>
            <source>Filter</source>
            <translation>Filter</translation>
        </message>
        <message>
            <source>Show only the loops with these words: a number, a kind, a state, a file (Ctrl+L)</source>
            <translation>Show only the loops with these words: a number, a kind, a state, a file (Ctrl+L)</translation>
        </message>
        <message>
            <source>All loops</source>
            <translation>All loops</translation>
        </message>
        <message>
            <source>To do</source>
            <translation>To do</translation>
        </message>
        <message>
            <source>Filled</source>
            <translation>Filled</translation>
        </message>
        <message>
            <source>Accepted</source>
            <translation>Accepted</translation>
        </message>
        <message>
            <source>Trouble</source>
            <translation>Trouble</translation>
        </message>
        <message>
            <source>Left out</source>
            <translation>Left out</translation>
        </message>
        <message>
            <source>Group</source>
            <translation>Group</translation>
        </message>
        <message>
            <source>Show only the loops of one group</source>
            <translation>Show only the loops of one group</translation>
        </message>
        <message>
            <source>Boundary loops</source>
            <translation>Boundary loops</translation>
        </message>
        <message>
            <source>Every boundary loop; double click or Return flies there</source>
            <translation>Every boundary loop; double click or Return flies there</translation>
        </message>
        <message>
            <source>No scan is open</source>
            <translation>No scan is open</translation>
        </message>
        <message>
            <source>No holes: closed surface</source>
            <translation>No holes: closed surface</translation>
        </message>
        <message numerus="yes">
            <source>%n hole(s), %1 open</source>
            <translation>
                <numerusform>%n hole, %1 open</numerusform>
                <numerusform>%n holes, %1 open</numerusform>
            </translation>
        </message>
        <message>
            <source>; %1 left out</source>
            <translation>; %1 left out</translation>
        </message>
        <message>
            <source>; %1 shown</source>
            <translation>; %1 shown</translation>
        </message>
        <message>
            <source>&amp;Sort by</source>
            <translation>&amp;Sort by</translation>
        </message>
    </context>
    <context>
        <name>loopmend::InspectPanel</name>
        <message>
            <source>Hole</source>
            <translation>Hole</translation>
        </message>
        <message>
            <source>The hole's number</source>
            <translation>The hole's number</translation>
        </message>
        <message>
            <source>Angle between the normals on both sides, root mean square</source>
            <translation>Angle between the normals on both sides, root mean square</translation>
        </message>
        <message>
            <source>Angle between the normals on both sides, largest</source>
            <translation>Angle between the normals on both sides, largest</translation>
        </message>
        <message>
            <source>Jump of the mean curvature across the seam, root mean square, 1/length</source>
            <translation>Jump of the mean curvature across the seam, root mean square, 1/length</translation>
        </message>
        <message>
            <source>Jump of the mean curvature across the seam, largest, 1/length</source>
            <translation>Jump of the mean curvature across the seam, largest, 1/length</translation>
        </message>
        <message>
            <source>The rms jump times the hole's diameter: a number without a unit</source>
            <translation>The rms jump times the hole's diameter: a number without a unit</translation>
        </message>
        <message>
            <source>Seams</source>
            <translation>Seams</translation>
        </message>
        <message>
            <source>How each patch meets the scan, before the flow and now</source>
            <translation>How each patch meets the scan, before the flow and now</translation>
        </message>
        <message>
            <source>Cop&amp;y</source>
            <translation>Cop&amp;y</translation>
        </message>
        <message>
            <source>Copy the table as tab-separated text</source>
            <translation>Copy the table as tab-separated text</translation>
        </message>
        <message>
            <source>Seam, before → now</source>
            <translation>Seam, before → now</translation>
        </message>
        <message>
            <source>Energy</source>
            <translation>Energy</translation>
        </message>
        <message>
            <source>Section</source>
            <translation>Section</translation>
        </message>
        <message>
            <source>Log</source>
            <translation>Log</translation>
        </message>
        <message>
            <source>Energy and residual against the step</source>
            <translation>Energy and residual against the step</translation>
        </message>
        <message>
            <source>Mean curvature along a section across the seam</source>
            <translation>Mean curvature along a section across the seam</translation>
        </message>
        <message>
            <source>What has happened so far</source>
            <translation>What has happened so far</translation>
        </message>
        <message>
            <source>Energy, section, log</source>
            <translation>Energy, section, log</translation>
        </message>
        <message>
            <source>What happens is written down here.</source>
            <translation>What happens is written down here.</translation>
        </message>
        <message>
            <source>Cop&amp;y log</source>
            <translation>Cop&amp;y log</translation>
        </message>
        <message>
            <source>Copy the whole log</source>
            <translation>Copy the whole log</translation>
        </message>
        <message>
            <source>Open a scan, fill a hole, and its seam is measured here.</source>
            <translation>Open a scan, fill a hole, and its seam is measured here.</translation>
        </message>
        <message>
            <source>No hole is filled yet. Press Fill, and the seam is measured here.</source>
            <translation>No hole is filled yet. Press Fill, and the seam is measured here.</translation>
        </message>
        <message>
            <source>The selection is not filled yet.</source>
            <translation>The selection is not filled yet.</translation>
        </message>
        <message>
            <source>Hole %1: %2</source>
            <translation>Hole %1: %2</translation>
        </message>
        <message>
            <source>Angle rms</source>
            <translation>Angle rms</translation>
        </message>
        <message>
            <source>Angle max</source>
            <translation>Angle max</translation>
        </message>
        <message>
            <source>H jump rms</source>
            <translation>H jump rms</translation>
        </message>
        <message>
            <source>H jump max</source>
            <translation>H jump max</translation>
        </message>
        <message>
            <source>H jump · size</source>
            <translation>H jump · size</translation>
        </message>
    </context>
    <context>
        <name>loopmend::LegendStrip</name>
        <message>
            <source>Legend</source>
            <translation>Legend</translation>
        </message>
        <message>
            <source>The colours of all pictures</source>
            <translation>The colours of all pictures</translation>
        </message>
        <message>
            <source>Mean curvature H</source>
            <translation>Mean curvature H</translation>
        </message>
        <message>
            <source>Gaussian curv. K</source>
            <translation>Gaussian curv. K</translation>
        </message>
        <message>
            <source>in 1/length</source>
            <translation>in 1/length</translation>
        </message>
        <message>
            <source>in 1/length²</source>
            <translation>in 1/length²</translation>
        </message>
        <message>
            <source>hollow</source>
            <translation>hollow</translation>
        </message>
        <message>
            <source>dome or bowl</source>
            <translation>dome or bowl</translation>
        </message>
        <message>
            <source>bulging</source>
            <translation>bulging</translation>
        </message>
        <message>
            <source>saddle</source>
            <translation>saddle</translation>
        </message>
    </context>
    <context>
        <name>loopmend::LookPanel</name>
        <message>
            <source>Blue, orange</source>
            <translation>Blue, orange</translation>
        </message>
        <message>
            <source>Purple, green</source>
            <translation>Purple, green</translation>
        </message>
        <message>
            <source>Brown, teal</source>
            <translation>Brown, teal</translation>
        </message>
        <message>
            <source>Grey</source>
            <translation>Grey</translation>
        </message>
        <message>
            <source>Mean curvature H: a patch that fits continues the scan's colours.</source>
            <translation>Mean curvature H: a patch that fits continues the scan's colours.</translation>
        </message>
        <message>
            <source>Gaussian curvature K: domes and bowls against saddles.</source>
            <translation>Gaussian curvature K: domes and bowls against saddles.</translation>
        </message>
        <message>
            <source>One colour; patches in another, so that they are found.</source>
            <translation>One colour; patches in another, so that they are found.</translation>
        </message>
        <message>
            <source>Reflected stripes: broken where tangents jump, kinked where the curvature jumps.</source>
            <translation>Reflected stripes: broken where tangents jump, kinked where the curvature jumps.</translation>
        </message>
        <message>
            <source>Bands of equal brightness: they stay when you move closer, and kink where tangents jump.</source>
            <translation>Bands of equal brightness: they stay when you move closer, and kink where tangents jump.</translation>
        </message>
        <message>
            <source>Shading</source>
            <translation>Shading</translation>
        </message>
        <message>
            <source>How surfaces are shown (keys 1 to 5)</source>
            <translation>How surfaces are shown (keys 1 to 5)</translation>
        </message>
        <message>
            <source>Stripes</source>
            <translation>Stripes</translation>
        </message>
        <message>
            <source>How many stripes or bands there are</source>
            <translation>How many stripes or bands there are</translation>
        </message>
        <message>
            <source>&amp;Wireframe: the triangles' edges</source>
            <translation>&amp;Wireframe: the triangles' edges</translation>
        </message>
        <message>
            <source>Wireframe</source>
            <translation>Wireframe</translation>
        </message>
        <message>
            <source>Draw the triangles' edges (W)</source>
            <translation>Draw the triangles' edges (W)</translation>
        </message>
        <message>
            <source>Rims and sea&amp;ms as lines</source>
            <translation>Rims and sea&amp;ms as lines</translation>
        </message>
        <message>
            <source>Rims and seams</source>
            <translation>Rims and seams</translation>
        </message>
        <message>
            <source>Draw the rims of holes and the seams of patches (M)</source>
            <translation>Draw the rims of holes and the seams of patches (M)</translation>
        </message>
        <message>
            <source>Drawn over it</source>
            <translation>Drawn over it</translation>
        </message>
        <message>
            <source>Colours</source>
            <translation>Colours</translation>
        </message>
        <message>
            <source>Every one of them can be told apart by every kind of colour vision</source>
            <translation>Every one of them can be told apart by every kind of colour vision</translation>
        </message>
        <message>
            <source>Percentile of the scan</source>
            <translation>Percentile of the scan</translation>
        </message>
        <message>
            <source>Own range</source>
            <translation>Own range</translation>
        </message>
        <message>
            <source>Range</source>
            <translation>Range</translation>
        </message>
        <message>
            <source>How far the colours reach. The range is symmetric about 0 and comes from the scan alone, so it stays the same while a flow runs</source>
            <translation>How far the colours reach. The range is symmetric about 0 and comes from the scan alone, so it stays the same while a flow runs</translation>
        </message>
        <message>
            <source>Percentile</source>
            <translation>Percentile</translation>
        </message>
        <message>
            <source>This share of the scan's values lies within the range</source>
            <translation>This share of the scan's values lies within the range</translation>
        </message>
        <message>
            <source>The curvature at the ends of the colours</source>
            <translation>The curvature at the ends of the colours</translation>
        </message>
    </context>
    <context>
        <name>loopmend::MainWindow</name>
        <message>
            <source>Holes</source>
            <translation>Holes</translation>
        </message>
        <message>
            <source>Patch</source>
            <translation>Patch</translation>
        </message>
        <message>
            <source>Look</source>
            <translation>Look</translation>
        </message>
        <message>
            <source>Inspect</source>
            <translation>Inspect</translation>
        </message>
        <message>
            <source>%1 and %2 more</source>
            <translation>%1 and %2 more</translation>
        </message>
        <message>
            <source>Loopmend</source>
            <translation>Loopmend</translation>
        </message>
        <message>
            <source>%1[*] – Loopmend</source>
            <translation>%1[*] – Loopmend</translation>
        </message>
        <message>
            <source>&amp;Undo: %1</source>
            <translation>&amp;Undo: %1</translation>
        </message>
        <message>
            <source>&amp;Undo</source>
            <translation>&amp;Undo</translation>
        </message>
        <message>
            <source>&amp;Redo: %1</source>
            <translation>&amp;Redo: %1</translation>
        </message>
        <message>
            <source>&amp;Redo</source>
            <translation>&amp;Redo</translation>
        </message>
        <message>
            <source>Wrote %1.</source>
            <translation>Wrote %1.</translation>
        </message>
        <message>
            <source>Tools</source>
            <translation>Tools</translation>
        </message>
    </context>
    <context>
        <name>loopmend::MeshView</name>
        <message>
            <source>Mean curvature H</source>
            <translation>Mean curvature H</translation>
        </message>
        <message>
            <source>Gaussian curvature K</source>
            <translation>Gaussian curvature K</translation>
        </message>
        <message>
            <source>in 1/length</source>
            <translation>in 1/length</translation>
        </message>
        <message>
            <source>in 1/length²</source>
            <translation>in 1/length²</translation>
        </message>
        <message>
            <source>hollow</source>
            <translation>hollow</translation>
        </message>
        <message>
            <source>dome or bowl</source>
            <translation>dome or bowl</translation>
        </message>
        <message>
            <source>bulging</source>
            <translation>bulging</translation>
        </message>
        <message>
            <source>saddle</source>
            <translation>saddle</translation>
        </message>
        <message>
            <source>Hole</source>
            <translation>Hole</translation>
        </message>
        <message>
            <source>%1 %2 · %3 edges · %4 across · %5</source>
            <translation>%1 %2 · %3 edges · %4 across · %5</translation>
        </message>
    </context>
    <context>
        <name>loopmend::PictureDialog</name>
        <message>
            <source>Screenshot</source>
            <translation>Screenshot</translation>
        </message>
        <message>
            <source>Size</source>
            <translation>Size</translation>
        </message>
        <message>
            <source>How many pixels the picture has</source>
            <translation>How many pixels the picture has</translation>
        </message>
        <message>
            <source>As on the screen</source>
            <translation>As on the screen</translation>
        </message>
        <message>
            <source>Twice as large</source>
            <translation>Twice as large</translation>
        </message>
        <message>
            <source>Four times as large</source>
            <translation>Four times as large</translation>
        </message>
        <message>
            <source>Own size</source>
            <translation>Own size</translation>
        </message>
        <message>
            <source> px</source>
            <translation> px</translation>
        </message>
        <message>
            <source>Width in pixels</source>
            <translation>Width in pixels</translation>
        </message>
        <message>
            <source>Height in pixels</source>
            <translation>Height in pixels</translation>
        </message>
        <message>
            <source>Ground</source>
            <translation>Ground</translation>
        </message>
        <message>
            <source>What is behind the surface</source>
            <translation>What is behind the surface</translation>
        </message>
        <message>
            <source>Transparent</source>
            <translation>Transparent</translation>
        </message>
        <message>
            <source>With</source>
            <translation>With</translation>
        </message>
        <message>
            <source>What is drawn beside the surface</source>
            <translation>What is drawn beside the surface</translation>
        </message>
        <message>
            <source>Legend, axes and scale bar</source>
            <translation>Legend, axes and scale bar</translation>
        </message>
        <message>
            <source>Legend</source>
            <translation>Legend</translation>
        </message>
        <message>
            <source>The surface alone</source>
            <translation>The surface alone</translation>
        </message>
        <message>
            <source>&amp;Save…</source>
            <translation>&amp;Save…</translation>
        </message>
        <message>
            <source>Choose a file and write the picture</source>
            <translation>Choose a file and write the picture</translation>
        </message>
        <message>
            <source>&amp;Copy</source>
            <translation>&amp;Copy</translation>
        </message>
        <message>
            <source>Put the picture into the clipboard</source>
            <translation>Put the picture into the clipboard</translation>
        </message>
        <message>
            <source>Si&amp;ze</source>
            <translation>Si&amp;ze</translation>
        </message>
        <message>
            <source>&amp;Ground</source>
            <translation>&amp;Ground</translation>
        </message>
        <message>
            <source>&amp;With</source>
            <translation>&amp;With</translation>
        </message>
        <message>
            <source>The graphics cannot draw a picture of this size. Choose a smaller one.</source>
            <translation>The graphics cannot draw a picture of this size. Choose a smaller one.</translation>
        </message>
        <message>
            <source>%1 cannot be written. Choose another folder, or check how much space is left.</source>
            <translation>%1 cannot be written. Choose another folder, or check how much space is left.</translation>
        </message>
        <message>
            <source>PNG (*.png)</source>
            <translation>PNG (*.png)</translation>
        </message>
        <message>
            <source>Headings and legend</source>
            <translation>Headings and legend</translation>
        </message>
        <message>
            <source>The surfaces alone</source>
            <translation>The surfaces alone</translation>
        </message>
    </context>
    <context>
        <name>loopmend::PlacePart</name>
        <message>
            <source>Place %1</source>
            <translation>Place %1</translation>
        </message>
    </context>
    <context>
        <name>loopmend::PointsBox</name>
        <message>
            <source>&amp;All vertices</source>
            <translation>&amp;All vertices</translation>
        </message>
        <message>
            <source>Only those I pic&amp;k</source>
            <translation>Only those I pic&amp;k</translation>
        </message>
        <message>
            <source>Clea&amp;r</source>
            <translation>Clea&amp;r</translation>
        </message>
        <message>
            <source>No vertex is picked</source>
            <translation>No vertex is picked</translation>
        </message>
        <message>
            <source>Its ri&amp;ms stay as they are</source>
            <translation>Its ri&amp;ms stay as they are</translation>
        </message>
        <message>
            <source>A smooth surface through the vertices of a polyhedron. Open or drop one; its faces are divided, and the flow finds the rest.</source>
            <translation>A smooth surface through the vertices of a polyhedron. Open or drop one; its faces are divided, and the flow finds the rest.</translation>
        </message>
        <message>
            <source>Polyhedron</source>
            <translation>Polyhedron</translation>
        </message>
        <message>
            <source>Which of the open surfaces is meant</source>
            <translation>Which of the open surfaces is meant</translation>
        </message>
        <message>
            <source>All vertices</source>
            <translation>All vertices</translation>
        </message>
        <message>
            <source>The surface runs through every vertex</source>
            <translation>The surface runs through every vertex</translation>
        </message>
        <message>
            <source>Only those I pick</source>
            <translation>Only those I pick</translation>
        </message>
        <message>
            <source>Click vertices in the picture, or draw a box around them; Ctrl takes away</source>
            <translation>Click vertices in the picture, or draw a box around them; Ctrl takes away</translation>
        </message>
        <message>
            <source>Subdivisions</source>
            <translation>Subdivisions</translation>
        </message>
        <message>
            <source>Every one makes four triangles of each</source>
            <translation>Every one makes four triangles of each</translation>
        </message>
        <message>
            <source>Smooth rims</source>
            <translation>Smooth rims</translation>
        </message>
        <message>
            <source>For a polyhedron with holes: its rims become smooth curves through their vertices</source>
            <translation>For a polyhedron with holes: its rims become smooth curves through their vertices</translation>
        </message>
        <message>
            <source>S&amp;ubdivisions</source>
            <translation>S&amp;ubdivisions</translation>
        </message>
        <message>
            <source>Open a polyhedron first.</source>
            <translation>Open a polyhedron first.</translation>
        </message>
        <message>
            <source>At least 4 vertices have to be picked.</source>
            <translation>At least 4 vertices have to be picked.</translation>
        </message>
        <message>
            <source>This surface has holes: close them, or let its rims become smooth curves.</source>
            <translation>This surface has holes: close them, or let its rims become smooth curves.</translation>
        </message>
        <message>
            <source>That would be more than 4 million triangles: fewer subdivisions do.</source>
            <translation>That would be more than 4 million triangles: fewer subdivisions do.</translation>
        </message>
        <message>
            <source>%1 vertices stay</source>
            <translation>%1 vertices stay</translation>
        </message>
        <message>
            <source>%1 triangles</source>
            <translation>%1 triangles</translation>
        </message>
    </context>
    <context>
        <name>loopmend::PreferencesDialog</name>
        <message>
            <source>Preferences</source>
            <translation>Preferences</translation>
        </message>
        <message>
            <source>Language</source>
            <translation>Language</translation>
        </message>
        <message>
            <source>Counts when the program starts the next time</source>
            <translation>Counts when the program starts the next time</translation>
        </message>
        <message>
            <source>As the system has it</source>
            <translation>As the system has it</translation>
        </message>
        <message>
            <source>Colours of the window</source>
            <translation>Colours of the window</translation>
        </message>
        <message>
            <source>Light or dark</source>
            <translation>Light or dark</translation>
        </message>
        <message>
            <source>Light</source>
            <translation>Light</translation>
        </message>
        <message>
            <source>Dark</source>
            <translation>Dark</translation>
        </message>
        <message>
            <source>Colours of curvature</source>
            <translation>Colours of curvature</translation>
        </message>
        <message>
            <source>The colours to begin with</source>
            <translation>The colours to begin with</translation>
        </message>
        <message>
            <source>Memory for undo</source>
            <translation>Memory for undo</translation>
        </message>
        <message>
            <source>Above this, the oldest changes can no longer be taken back</source>
            <translation>Above this, the oldest changes can no longer be taken back</translation>
        </message>
        <message>
            <source>MB</source>
            <translation>MB</translation>
        </message>
        <message>
            <source>Memory for each timeline</source>
            <translation>Memory for each timeline</translation>
        </message>
        <message>
            <source>Above this, every second recorded state of a patch is forgotten</source>
            <translation>Above this, every second recorded state of a patch is forgotten</translation>
        </message>
        <message>
            <source>Copy for recovery after</source>
            <translation>Copy for recovery after</translation>
        </message>
        <message>
            <source>This long after a change, a copy is written that survives a crash</source>
            <translation>This long after a change, a copy is written that survives a crash</translation>
        </message>
        <message>
            <source>s</source>
            <translation>s</translation>
        </message>
        <message>
            <source>&amp;Language</source>
            <translation>&amp;Language</translation>
        </message>
        <message>
            <source>&amp;Window</source>
            <translation>&amp;Window</translation>
        </message>
        <message>
            <source>C&amp;urvature</source>
            <translation>C&amp;urvature</translation>
        </message>
        <message>
            <source>Memory for un&amp;do</source>
            <translation>Memory for un&amp;do</translation>
        </message>
        <message>
            <source>Memory for each &amp;timeline</source>
            <translation>Memory for each &amp;timeline</translation>
        </message>
        <message>
            <source>Copy for &amp;recovery after</source>
            <translation>Copy for &amp;recovery after</translation>
        </message>
        <message>
            <source>Every change counts at once; another language from the next start on.</source>
            <translation>Every change counts at once; another language from the next start on.</translation>
        </message>
    </context>
    <context>
        <name>loopmend::ProgressBox</name>
        <message>
            <source>Nothing is running.</source>
            <translation>Nothing is running.</translation>
        </message>
        <message>
            <source>Progress</source>
            <translation>Progress</translation>
        </message>
        <message>
            <source>How far the present job is</source>
            <translation>How far the present job is</translation>
        </message>
        <message>
            <source>Ca&amp;ncel</source>
            <translation>Ca&amp;ncel</translation>
        </message>
        <message>
            <source>Stop at once; what was accepted so far is kept (Esc)</source>
            <translation>Stop at once; what was accepted so far is kept (Esc)</translation>
        </message>
        <message>
            <source>%1, %2: step %3, energy %4 (from %5)</source>
            <translation>%1, %2: step %3, energy %4 (from %5)</translation>
        </message>
        <message>
            <source>, residual %1 edge lengths</source>
            <translation>, residual %1 edge lengths</translation>
        </message>
        <message>
            <source>, %1 s</source>
            <translation>, %1 s</translation>
        </message>
    </context>
    <context>
        <name>loopmend::RegionBox</name>
        <message>
            <source>&amp;Brush</source>
            <translation>&amp;Brush</translation>
        </message>
        <message>
            <source>Paint the region with the left button</source>
            <translation>Paint the region with the left button</translation>
        </message>
        <message>
            <source>La&amp;sso</source>
            <translation>La&amp;sso</translation>
        </message>
        <message>
            <source>Draw an outline around the region</source>
            <translation>Draw an outline around the region</translation>
        </message>
        <message>
            <source>&amp;Add</source>
            <translation>&amp;Add</translation>
        </message>
        <message>
            <source>What is painted joins the region; Ctrl takes away</source>
            <translation>What is painted joins the region; Ctrl takes away</translation>
        </message>
        <message>
            <source>&amp;Take away</source>
            <translation>&amp;Take away</translation>
        </message>
        <message>
            <source>What is painted leaves the region; Ctrl adds</source>
            <translation>What is painted leaves the region; Ctrl adds</translation>
        </message>
        <message>
            <source>Also what is &amp;hidden</source>
            <translation>Also what is &amp;hidden</translation>
        </message>
        <message>
            <source>Width of the brush</source>
            <translation>Width of the brush</translation>
        </message>
        <message>
            <source>&amp;Grow</source>
            <translation>&amp;Grow</translation>
        </message>
        <message>
            <source>One ring of triangles more</source>
            <translation>One ring of triangles more</translation>
        </message>
        <message>
            <source>S&amp;hrink</source>
            <translation>S&amp;hrink</translation>
        </message>
        <message>
            <source>One ring of triangles less</source>
            <translation>One ring of triangles less</translation>
        </message>
        <message>
            <source>Clea&amp;r</source>
            <translation>Clea&amp;r</translation>
        </message>
        <message>
            <source>Begin the region anew</source>
            <translation>Begin the region anew</translation>
        </message>
        <message>
            <source>Paint what shall become smooth; everything else is held. Drag beside the surface, or with Shift, to turn the picture.</source>
            <translation>Paint what shall become smooth; everything else is held. Drag beside the surface, or with Shift, to turn the picture.</translation>
        </message>
        <message>
            <source>How wide the brush is on the screen</source>
            <translation>How wide the brush is on the screen</translation>
        </message>
        <message>
            <source>Also what is hidden</source>
            <translation>Also what is hidden</translation>
        </message>
        <message>
            <source>The lasso takes what lies behind the surface as well</source>
            <translation>The lasso takes what lies behind the surface as well</translation>
        </message>
        <message>
            <source>%1 vertices</source>
            <translation>%1 vertices</translation>
        </message>
        <message>
            <source>Nothing is painted yet.</source>
            <translation>Nothing is painted yet.</translation>
        </message>
    </context>
    <context>
        <name>loopmend::ScanCommands</name>
        <message>
            <source>%1 took several runs, or was stopped halfway through one; the command repeats the last run only.</source>
            <translation>%1 took several runs, or was stopped halfway through one; the command repeats the last run only.</translation>
        </message>
        <message>
            <source>%1: the patch cuts the surface; the command would leave it open.</source>
            <translation>%1: the patch cuts the surface; the command would leave it open.</translation>
        </message>
        <message>
            <source>%1 was made in the window: export it as surface.ply, without patches, before you use the command.</source>
            <translation>%1 was made in the window: export it as surface.ply, without patches, before you use the command.</translation>
        </message>
    </context>
    <context>
        <name>loopmend::SectionView</name>
        <message>
            <source>Mean curvature along a section across the seam</source>
            <translation>Mean curvature along a section across the seam</translation>
        </message>
        <message>
            <source>Direction of the section</source>
            <translation>Direction of the section</translation>
        </message>
        <message>
            <source>Turns the section about the hole's axis; 0° runs along the hole's longest direction</source>
            <translation>Turns the section about the hole's axis; 0° runs along the hole's longest direction</translation>
        </message>
        <message>
            <source>%1°</source>
            <translation>%1°</translation>
        </message>
        <message>
            <source>Fill a hole, and H across its seam is drawn here.</source>
            <translation>Fill a hole, and H across its seam is drawn here.</translation>
        </message>
        <message>
            <source>H of scan</source>
            <translation>H of scan</translation>
        </message>
        <message>
            <source>patch</source>
            <translation>patch</translation>
        </message>
        <message>
            <source>filler</source>
            <translation>filler</translation>
        </message>
        <message>
            <source>±σ</source>
            <translation>±σ</translation>
        </message>
    </context>
    <context>
        <name>loopmend::ShortcutSheet</name>
        <message>
            <source> or </source>
            <translation> or </translation>
        </message>
        <message>
            <source>Drag</source>
            <translation>Drag</translation>
        </message>
        <message>
            <source>Turn</source>
            <translation>Turn</translation>
        </message>
        <message>
            <source>Shift+drag, middle button</source>
            <translation>Shift+drag, middle button</translation>
        </message>
        <message>
            <source>Move sideways</source>
            <translation>Move sideways</translation>
        </message>
        <message>
            <source>Wheel, right button, +, −</source>
            <translation>Wheel, right button, +, −</translation>
        </message>
        <message>
            <source>Closer, further away</source>
            <translation>Closer, further away</translation>
        </message>
        <message>
            <source>Arrow keys</source>
            <translation>Arrow keys</translation>
        </message>
        <message>
            <source>Turn by ten degrees</source>
            <translation>Turn by ten degrees</translation>
        </message>
        <message>
            <source>Click on a rim</source>
            <translation>Click on a rim</translation>
        </message>
        <message>
            <source>Select; with Ctrl, add</source>
            <translation>Select; with Ctrl, add</translation>
        </message>
        <message>
            <source>Double click on a rim or row</source>
            <translation>Double click on a rim or row</translation>
        </message>
        <message>
            <source>Fly there</source>
            <translation>Fly there</translation>
        </message>
        <message>
            <source>Click on a surface</source>
            <translation>Click on a surface</translation>
        </message>
        <message>
            <source>Show the values at this point</source>
            <translation>Show the values at this point</translation>
        </message>
        <message>
            <source>Tab</source>
            <translation>Tab</translation>
        </message>
        <message>
            <source>From control to control</source>
            <translation>From control to control</translation>
        </message>
        <message>
            <source>Return in the table</source>
            <translation>Return in the table</translation>
        </message>
        <message>
            <source>Fly to the hole</source>
            <translation>Fly to the hole</translation>
        </message>
        <message>
            <source>Keyboard shortcuts</source>
            <translation>Keyboard shortcuts</translation>
        </message>
        <message>
            <source>Mouse and keys in the picture</source>
            <translation>Mouse and keys in the picture</translation>
        </message>
        <message>
            <source>Shift+arrow keys</source>
            <translation>Shift+arrow keys</translation>
        </message>
        <message>
            <source>Menu key in the table</source>
            <translation>Menu key in the table</translation>
        </message>
        <message>
            <source>Sort, choose columns</source>
            <translation>Sort, choose columns</translation>
        </message>
    </context>
    <context>
        <name>loopmend::SmallHolesBox</name>
        <message>
            <source>Fill all &amp;up to</source>
            <translation>Fill all &amp;up to</translation>
        </message>
        <message>
            <source>Largest size</source>
            <translation>Largest size</translation>
        </message>
        <message>
            <source>Holes up to this size are meant</source>
            <translation>Holes up to this size are meant</translation>
        </message>
        <message>
            <source>edges</source>
            <translation>edges</translation>
        </message>
        <message>
            <source>diameter</source>
            <translation>diameter</translation>
        </message>
        <message>
            <source>Measure</source>
            <translation>Measure</translation>
        </message>
        <message>
            <source>What the size of a hole is: edges along its rim, or its diameter in the scan's unit</source>
            <translation>What the size of a hole is: edges along its rim, or its diameter in the scan's unit</translation>
        </message>
        <message>
            <source>Fill</source>
            <translation>Fill</translation>
        </message>
        <message>
            <source>Fill every open hole up to this size</source>
            <translation>Fill every open hole up to this size</translation>
        </message>
        <message>
            <source>Include outer rims</source>
            <translation>Include outer rims</translation>
        </message>
        <message>
            <source>The rim of an open sheet looks like a hole to a program. It is left out unless you include it here, or select it yourself</source>
            <translation>The rim of an open sheet looks like a hole to a program. It is left out unless you include it here, or select it yourself</translation>
        </message>
        <message>
            <source>Fill %1 of %2</source>
            <translation>Fill %1 of %2</translation>
        </message>
        <message>
            <source>Include outer &amp;rims of open sheets (%1)</source>
            <translation>Include outer &amp;rims of open sheets (%1)</translation>
        </message>
        <message>
            <source>Include outer &amp;rims of open sheets (none here)</source>
            <translation>Include outer &amp;rims of open sheets (none here)</translation>
        </message>
    </context>
    <context>
        <name>loopmend::StatusLine</name>
        <message>
            <source>Ready</source>
            <translation>Ready</translation>
        </message>
        <message>
            <source>%1 triangles · %2 vertices</source>
            <translation>%1 triangles · %2 vertices</translation>
        </message>
        <message>
            <source>step %1 · energy %2</source>
            <translation>step %1 · energy %2</translation>
        </message>
        <message>
            <source> · residual %1</source>
            <translation> · residual %1</translation>
        </message>
        <message>
            <source> · σ %1 · τ %2</source>
            <translation> · σ %1 · τ %2</translation>
        </message>
        <message>
            <source> · %1 s</source>
            <translation> · %1 s</translation>
        </message>
    </context>
    <context>
        <name>loopmend::ToolDesk</name>
        <message>
            <source>Paint a region first.</source>
            <translation>Paint a region first.</translation>
        </message>
        <message>
            <source>Region of %1</source>
            <translation>Region of %1</translation>
        </message>
        <message>
            <source>Surface through the points of %1</source>
            <translation>Surface through the points of %1</translation>
        </message>
        <message>
            <source>Blend of %1</source>
            <translation>Blend of %1</translation>
        </message>
    </context>
    <context>
        <name>loopmend::ToolsPanel</name>
        <message>
            <source>Region</source>
            <translation>Region</translation>
        </message>
        <message>
            <source>Make a region of a surface smooth, its surroundings held (R)</source>
            <translation>Make a region of a surface smooth, its surroundings held (R)</translation>
        </message>
        <message>
            <source>Points</source>
            <translation>Points</translation>
        </message>
        <message>
            <source>A smooth surface through the vertices of a polyhedron (I)</source>
            <translation>A smooth surface through the vertices of a polyhedron (I)</translation>
        </message>
        <message>
            <source>Blend</source>
            <translation>Blend</translation>
        </message>
        <message>
            <source>Join two or more rims by one patch (B)</source>
            <translation>Join two or more rims by one patch (B)</translation>
        </message>
        <message>
            <source>Choose a tool. Region makes a part of a surface smooth; Points finds a surface through the vertices of a polyhedron; Blend joins rims of one or several parts.</source>
            <translation>Choose a tool. Region makes a part of a surface smooth; Points finds a surface through the vertices of a polyhedron; Blend joins rims of one or several parts.</translation>
        </message>
        <message>
            <source>Surface through points</source>
            <translation>Surface through points</translation>
        </message>
        <message>
            <source>Join rims</source>
            <translation>Join rims</translation>
        </message>
    </context>
    <context>
        <name>loopmend::Trial</name>
        <message>
            <source>Making the start…</source>
            <translation>Making the start…</translation>
        </message>
        <message>
            <source>%1 free vertices.</source>
            <translation>%1 free vertices.</translation>
        </message>
        <message>
            <source>%1 at work…</source>
            <translation>%1 at work…</translation>
        </message>
        <message>
            <source>Step %1, energy %2, %3 vertices</source>
            <translation>Step %1, energy %2, %3 vertices</translation>
        </message>
        <message>
            <source>%1 steps, energy %2 → %3.</source>
            <translation>%1 steps, energy %2 → %3.</translation>
        </message>
        <message>
            <source>Cancelled.</source>
            <translation>Cancelled.</translation>
        </message>
        <message>
            <source>%1: taken over. Ctrl+Z takes it back.</source>
            <translation>%1: taken over. Ctrl+Z takes it back.</translation>
        </message>
        <message>
            <source>The main window is busy, or has gone on to something else.</source>
            <translation>The main window is busy, or has gone on to something else.</translation>
        </message>
        <message>
            <source>Taking over…</source>
            <translation>Taking over…</translation>
        </message>
        <message>
            <source>%1 was taken over into the main window; Ctrl+Z there takes it back.</source>
            <translation>%1 was taken over into the main window; Ctrl+Z there takes it back.</translation>
        </message>
        <message>
            <source>Converged after %1 steps, energy %2 → %3.</source>
            <translation>Converged after %1 steps, energy %2 → %3.</translation>
        </message>
    </context>
    <context>
        <name>loopmend::TrialBox</name>
        <message>
            <source>Try it, decide</source>
            <translation>Try it, decide</translation>
        </message>
        <message>
            <source>Pre&amp;view</source>
            <translation>Pre&amp;view</translation>
        </message>
        <message>
            <source>Show the start, before any flow</source>
            <translation>Show the start, before any flow</translation>
        </message>
        <message>
            <source>Evo&amp;lve</source>
            <translation>Evo&amp;lve</translation>
        </message>
        <message>
            <source>Co&amp;mpare flows…</source>
            <translation>Co&amp;mpare flows…</translation>
        </message>
        <message>
            <source>Several flows from this start, side by side, in a window of their own</source>
            <translation>Several flows from this start, side by side, in a window of their own</translation>
        </message>
        <message>
            <source>Ca&amp;ncel</source>
            <translation>Ca&amp;ncel</translation>
        </message>
        <message>
            <source>Stop at once; the start is shown again (Esc)</source>
            <translation>Stop at once; the start is shown again (Esc)</translation>
        </message>
        <message>
            <source>Ta&amp;ke over</source>
            <translation>Ta&amp;ke over</translation>
        </message>
        <message>
            <source>The result comes into the document; can be undone</source>
            <translation>The result comes into the document; can be undone</translation>
        </message>
        <message>
            <source>&amp;Discard</source>
            <translation>&amp;Discard</translation>
        </message>
        <message>
            <source>Give it up; the document is as it was</source>
            <translation>Give it up; the document is as it was</translation>
        </message>
        <message>
            <source>Which flow works on it</source>
            <translation>Which flow works on it</translation>
        </message>
        <message>
            <source>Cop&amp;y command line</source>
            <translation>Cop&amp;y command line</translation>
        </message>
        <message>
            <source>Copy the commands that do the same</source>
            <translation>Copy the commands that do the same</translation>
        </message>
        <message>
            <source>Boundary</source>
            <translation>Boundary</translation>
        </message>
        <message>
            <source>Continuity</source>
            <translation>Continuity</translation>
        </message>
        <message>
            <source>Let the flow work on it until it converges</source>
            <translation>Let the flow work on it until it converges</translation>
        </message>
    </context>
    <context>
        <name>loopmend::Welcome</name>
        <message>
            <source>Open a scan, or drop one here</source>
            <translation>Open a scan, or drop one here</translation>
        </message>
        <message>
            <source>PLY, STL, OBJ or OFF; or a saved session</source>
            <translation>PLY, STL, OBJ or OFF; or a saved session</translation>
        </message>
        <message>
            <source>&amp;Open…</source>
            <translation>&amp;Open…</translation>
        </message>
        <message>
            <source>Choose a file (Ctrl+O)</source>
            <translation>Choose a file (Ctrl+O)</translation>
        </message>
        <message>
            <source>&amp;Try the sample</source>
            <translation>&amp;Try the sample</translation>
        </message>
        <message>
            <source>A small made-up scan with five holes</source>
            <translation>A small made-up scan with five holes</translation>
        </message>
        <message>
            <source>Opened lately</source>
            <translation>Opened lately</translation>
        </message>
        <message>
            <source>Open %1</source>
            <translation>Open %1</translation>
        </message>
        <message>
            <source>Examples of the paper</source>
            <translation>Examples of the paper</translation>
        </message>
    </context>
    <context>
        <name>loopmend::WindowActions</name>
        <message>
            <source>&amp;Open…</source>
            <translation>&amp;Open…</translation>
        </message>
        <message>
            <source>Open a scan or a session</source>
            <translation>Open a scan or a session</translation>
        </message>
        <message>
            <source>&amp;Add to the scene…</source>
            <translation>&amp;Add to the scene…</translation>
        </message>
        <message>
            <source>Open further scans beside the present ones</source>
            <translation>Open further scans beside the present ones</translation>
        </message>
        <message>
            <source>Open the sa&amp;mple</source>
            <translation>Open the sa&amp;mple</translation>
        </message>
        <message>
            <source>Open a small made-up scan with five holes</source>
            <translation>Open a small made-up scan with five holes</translation>
        </message>
        <message>
            <source>&amp;Save session</source>
            <translation>&amp;Save session</translation>
        </message>
        <message>
            <source>Keep scans and patches as they are, to go on another day</source>
            <translation>Keep scans and patches as they are, to go on another day</translation>
        </message>
        <message>
            <source>Save session &amp;as…</source>
            <translation>Save session &amp;as…</translation>
        </message>
        <message>
            <source>Save the session under another name</source>
            <translation>Save the session under another name</translation>
        </message>
        <message>
            <source>&amp;Export…</source>
            <translation>&amp;Export…</translation>
        </message>
        <message>
            <source>Write scan and patches to a mesh file</source>
            <translation>Write scan and patches to a mesh file</translation>
        </message>
        <message>
            <source>S&amp;creenshot…</source>
            <translation>S&amp;creenshot…</translation>
        </message>
        <message>
            <source>Write the picture to a PNG file</source>
            <translation>Write the picture to a PNG file</translation>
        </message>
        <message>
            <source>&amp;Quit</source>
            <translation>&amp;Quit</translation>
        </message>
        <message>
            <source>Close the window</source>
            <translation>Close the window</translation>
        </message>
        <message>
            <source>&amp;Undo</source>
            <translation>&amp;Undo</translation>
        </message>
        <message>
            <source>Take back the last change</source>
            <translation>Take back the last change</translation>
        </message>
        <message>
            <source>&amp;Redo</source>
            <translation>&amp;Redo</translation>
        </message>
        <message>
            <source>Do it again</source>
            <translation>Do it again</translation>
        </message>
        <message>
            <source>Select &amp;all holes</source>
            <translation>Select &amp;all holes</translation>
        </message>
        <message>
            <source>Select every hole</source>
            <translation>Select every hole</translation>
        </message>
        <message>
            <source>&amp;Next hole</source>
            <translation>&amp;Next hole</translation>
        </message>
        <message>
            <source>Select the next hole of the table and fly there</source>
            <translation>Select the next hole of the table and fly there</translation>
        </message>
        <message>
            <source>&amp;Previous hole</source>
            <translation>&amp;Previous hole</translation>
        </message>
        <message>
            <source>Select the hole before and fly there</source>
            <translation>Select the hole before and fly there</translation>
        </message>
        <message>
            <source>&amp;Filter holes</source>
            <translation>&amp;Filter holes</translation>
        </message>
        <message>
            <source>Write into the filter of the holes table</source>
            <translation>Write into the filter of the holes table</translation>
        </message>
        <message>
            <source>Pre&amp;ferences…</source>
            <translation>Pre&amp;ferences…</translation>
        </message>
        <message>
            <source>Language, colours, memory, recovery</source>
            <translation>Language, colours, memory, recovery</translation>
        </message>
        <message>
            <source>&amp;Mean curvature</source>
            <translation>&amp;Mean curvature</translation>
        </message>
        <message>
            <source>Colour by mean curvature H</source>
            <translation>Colour by mean curvature H</translation>
        </message>
        <message>
            <source>&amp;Gaussian curvature</source>
            <translation>&amp;Gaussian curvature</translation>
        </message>
        <message>
            <source>Colour by Gaussian curvature K</source>
            <translation>Colour by Gaussian curvature K</translation>
        </message>
        <message>
            <source>&amp;Plain</source>
            <translation>&amp;Plain</translation>
        </message>
        <message>
            <source>One colour; patches in another</source>
            <translation>One colour; patches in another</translation>
        </message>
        <message>
            <source>&amp;Zebra</source>
            <translation>&amp;Zebra</translation>
        </message>
        <message>
            <source>Reflected stripes: kinks show where tangents or curvature jump</source>
            <translation>Reflected stripes: kinks show where tangents or curvature jump</translation>
        </message>
        <message>
            <source>&amp;Isophotes</source>
            <translation>&amp;Isophotes</translation>
        </message>
        <message>
            <source>Bands of equal brightness</source>
            <translation>Bands of equal brightness</translation>
        </message>
        <message>
            <source>&amp;Wireframe</source>
            <translation>&amp;Wireframe</translation>
        </message>
        <message>
            <source>Draw the triangles' edges</source>
            <translation>Draw the triangles' edges</translation>
        </message>
        <message>
            <source>&amp;Rims and seams</source>
            <translation>&amp;Rims and seams</translation>
        </message>
        <message>
            <source>Draw rims and seams as lines</source>
            <translation>Draw rims and seams as lines</translation>
        </message>
        <message>
            <source>&amp;Frame everything</source>
            <translation>&amp;Frame everything</translation>
        </message>
        <message>
            <source>See the whole scene</source>
            <translation>See the whole scene</translation>
        </message>
        <message>
            <source>&amp;Fill</source>
            <translation>&amp;Fill</translation>
        </message>
        <message>
            <source>Close the selected holes, or all</source>
            <translation>Close the selected holes, or all</translation>
        </message>
        <message>
            <source>&amp;Step</source>
            <translation>&amp;Step</translation>
        </message>
        <message>
            <source>Take one time step</source>
            <translation>Take one time step</translation>
        </message>
        <message>
            <source>&amp;Run or pause</source>
            <translation>&amp;Run or pause</translation>
        </message>
        <message>
            <source>&amp;To steady state</source>
            <translation>&amp;To steady state</translation>
        </message>
        <message>
            <source>Straight to where the flow comes to rest</source>
            <translation>Straight to where the flow comes to rest</translation>
        </message>
        <message>
            <source>&amp;Accept or open again</source>
            <translation>&amp;Accept or open again</translation>
        </message>
        <message>
            <source>Keep the patch as it is, or take it up again</source>
            <translation>Keep the patch as it is, or take it up again</translation>
        </message>
        <message>
            <source>R&amp;eject</source>
            <translation>R&amp;eject</translation>
        </message>
        <message>
            <source>Throw the patch away; the hole is open again</source>
            <translation>Throw the patch away; the hole is open again</translation>
        </message>
        <message>
            <source>&amp;Copy command line</source>
            <translation>&amp;Copy command line</translation>
        </message>
        <message>
            <source>Copy the commands that do the same</source>
            <translation>Copy the commands that do the same</translation>
        </message>
        <message>
            <source>Ca&amp;ncel</source>
            <translation>Ca&amp;ncel</translation>
        </message>
        <message>
            <source>Stop at once; or close a message; or select nothing</source>
            <translation>Stop at once; or close a message; or select nothing</translation>
        </message>
        <message>
            <source>&amp;Help</source>
            <translation>&amp;Help</translation>
        </message>
        <message>
            <source>How things are done, with pictures</source>
            <translation>How things are done, with pictures</translation>
        </message>
        <message>
            <source>&amp;Keyboard shortcuts</source>
            <translation>&amp;Keyboard shortcuts</translation>
        </message>
        <message>
            <source>All keys on one sheet</source>
            <translation>All keys on one sheet</translation>
        </message>
        <message>
            <source>A&amp;bout Loopmend</source>
            <translation>A&amp;bout Loopmend</translation>
        </message>
        <message>
            <source>Version and licence</source>
            <translation>Version and licence</translation>
        </message>
        <message>
            <source>%1 (%2)</source>
            <translation>%1 (%2)</translation>
        </message>
        <message>
            <source>&amp;File</source>
            <translation>&amp;File</translation>
        </message>
        <message>
            <source>Open &amp;recent</source>
            <translation>Open &amp;recent</translation>
        </message>
        <message>
            <source>C&amp;lose</source>
            <translation>C&amp;lose</translation>
        </message>
        <message>
            <source>&amp;Edit</source>
            <translation>&amp;Edit</translation>
        </message>
        <message>
            <source>&amp;View</source>
            <translation>&amp;View</translation>
        </message>
        <message>
            <source>&amp;Patch</source>
            <translation>&amp;Patch</translation>
        </message>
        <message>
            <source>Tools</source>
            <translation>Tools</translation>
        </message>
        <message>
            <source>Open</source>
            <translation>Open</translation>
        </message>
        <message>
            <source>Save</source>
            <translation>Save</translation>
        </message>
        <message>
            <source>Export</source>
            <translation>Export</translation>
        </message>
        <message>
            <source>H</source>
            <translation>H</translation>
        </message>
        <message>
            <source>K</source>
            <translation>K</translation>
        </message>
        <message>
            <source>&amp;Values in the middle</source>
            <translation>&amp;Values in the middle</translation>
        </message>
        <message>
            <source>Show the values at the middle of the picture</source>
            <translation>Show the values at the middle of the picture</translation>
        </message>
        <message>
            <source>&amp;Compare flows…</source>
            <translation>&amp;Compare flows…</translation>
        </message>
        <message>
            <source>Several flows from one start, side by side</source>
            <translation>Several flows from one start, side by side</translation>
        </message>
        <message>
            <source>&amp;Region</source>
            <translation>&amp;Region</translation>
        </message>
        <message>
            <source>Make a region of a surface smooth, its surroundings held</source>
            <translation>Make a region of a surface smooth, its surroundings held</translation>
        </message>
        <message>
            <source>Surface through &amp;points</source>
            <translation>Surface through &amp;points</translation>
        </message>
        <message>
            <source>A smooth surface through the vertices of a polyhedron</source>
            <translation>A smooth surface through the vertices of a polyhedron</translation>
        </message>
        <message>
            <source>&amp;Blend rims</source>
            <translation>&amp;Blend rims</translation>
        </message>
        <message>
            <source>Join two or more rims by one patch</source>
            <translation>Join two or more rims by one patch</translation>
        </message>
        <message>
            <source>&amp;Tools</source>
            <translation>&amp;Tools</translation>
        </message>
        <message>
            <source>Compare</source>
            <translation>Compare</translation>
        </message>
        <message>
            <source>Step after step until the flow converges</source>
            <translation>Step after step until the flow converges</translation>
        </message>
    </context>
    <context>
        <name>loopmend::Workbench</name>
        <message>
            <source>Filling %1</source>
            <translation>Filling %1</translation>
        </message>
        <message>
            <source>Fill %1</source>
            <translation>Fill %1</translation>
        </message>
        <message>
            <source>Filled %1 with %2 triangles in %3 s.</source>
            <translation>Filled %1 with %2 triangles in %3 s.</translation>
        </message>
        <message>
            <source>Some of these holes lie so close to filled ones that both were filled anew, as one.</source>
            <translation>Some of these holes lie so close to filled ones that both were filled anew, as one.</translation>
        </message>
        <message>
            <source>Hole %1: %2</source>
            <translation>Hole %1: %2</translation>
        </message>
        <message>
            <source>Hole %1 stays open: %2</source>
            <translation>Hole %1 stays open: %2</translation>
        </message>
        <message>
            <source>%1 of %2 holes could not be filled. The State column says why.</source>
            <translation>%1 of %2 holes could not be filled. The State column says why.</translation>
        </message>
        <message>
            <source>%1 step on %2</source>
            <translation>%1 step on %2</translation>
        </message>
        <message>
            <source>%1 on %2</source>
            <translation>%1 on %2</translation>
        </message>
        <message>
            <source>%1, %2: %3 steps, energy %4 → %5, %6 s.</source>
            <translation>%1, %2: %3 steps, energy %4 → %5, %6 s.</translation>
        </message>
        <message>
            <source>%1 could not be solved together; each was solved by itself.</source>
            <translation>%1 could not be solved together; each was solved by itself.</translation>
        </message>
        <message>
            <source>Pausing after this step</source>
            <translation>Pausing after this step</translation>
        </message>
        <message>
            <source>Cancelled; the last accepted state is kept.</source>
            <translation>Cancelled; the last accepted state is kept.</translation>
        </message>
        <message>
            <source>Cancelled.</source>
            <translation>Cancelled.</translation>
        </message>
        <message>
            <source>Accept %1</source>
            <translation>Accept %1</translation>
        </message>
        <message>
            <source>Reopen %1</source>
            <translation>Reopen %1</translation>
        </message>
        <message>
            <source>Reject %1</source>
            <translation>Reject %1</translation>
        </message>
        <message>
            <source>Go back on %1</source>
            <translation>Go back on %1</translation>
        </message>
        <message>
            <source>Opening %1</source>
            <translation>Opening %1</translation>
        </message>
        <message>
            <source>Opening %1 files</source>
            <translation>Opening %1 files</translation>
        </message>
        <message>
            <source>Making the sample</source>
            <translation>Making the sample</translation>
        </message>
        <message>
            <source> Opened in %1 s.</source>
            <translation> Opened in %1 s.</translation>
        </message>
        <message>
            <source>This surface is closed: there is no hole to fill.</source>
            <translation>This surface is closed: there is no hole to fill.</translation>
        </message>
        <message>
            <source>Computing curvature</source>
            <translation>Computing curvature</translation>
        </message>
        <message>
            <source>Add %1</source>
            <translation>Add %1</translation>
        </message>
        <message>
            <source>Close %1</source>
            <translation>Close %1</translation>
        </message>
        <message>
            <source>Restored %1: %2 patches, in %3 s.</source>
            <translation>Restored %1: %2 patches, in %3 s.</translation>
        </message>
        <message>
            <source>Writing %1</source>
            <translation>Writing %1</translation>
        </message>
        <message>
            <source>Saved the session as %1.</source>
            <translation>Saved the session as %1.</translation>
        </message>
        <message>
            <source> Left open, because the patch cuts the surface: %1.</source>
            <translation> Left open, because the patch cuts the surface: %1.</translation>
        </message>
        <message>
            <source>Wrote %1: %2 triangles.</source>
            <translation>Wrote %1: %2 triangles.</translation>
        </message>
        <message>
            <source>Taking over %1</source>
            <translation>Taking over %1</translation>
        </message>
        <message>
            <source> Not in it: %1.</source>
            <translation> Not in it: %1.</translation>
        </message>
        <message>
            <source> STL rounds: vertices were moved by up to %1; PLY keeps every digit.</source>
            <translation> STL rounds: vertices were moved by up to %1; PLY keeps every digit.</translation>
        </message>
    </context>
    <context>
        <name>loopmend::words</name>
        <message>
            <source>hole</source>
            <translation>hole</translation>
        </message>
        <message>
            <source>outer rim</source>
            <translation>outer rim</translation>
        </message>
        <message>
            <source>touching</source>
            <translation>touching</translation>
        </message>
        <message>
            <source>crack</source>
            <translation>crack</translation>
        </message>
        <message>
            <source>cut</source>
            <translation>cut</translation>
        </message>
        <message>
            <source>A hole in the surface.</source>
            <translation>A hole in the surface.</translation>
        </message>
        <message>
            <source>The rim of an open sheet. It is left out unless you select it yourself and press Fill.</source>
            <translation>The rim of an open sheet. It is left out unless you select it yourself and press Fill.</translation>
        </message>
        <message>
            <source>This loop passes twice through one vertex, or meets another loop there.</source>
            <translation>This loop passes twice through one vertex, or meets another loop there.</translation>
        </message>
        <message>
            <source>A crack: nothing is missing here, the two sides only are not joined. It is left out unless you select it.</source>
            <translation>A crack: nothing is missing here, the two sides only are not joined. It is left out unless you select it.</translation>
        </message>
        <message>
            <source>Not a hole: more than two triangles meet along this edge, so the surface was cut here.</source>
            <translation>Not a hole: more than two triangles meet along this edge, so the surface was cut here.</translation>
        </message>
        <message>
            <source>open</source>
            <translation>open</translation>
        </message>
        <message>
            <source>left out</source>
            <translation>left out</translation>
        </message>
        <message>
            <source>filled</source>
            <translation>filled</translation>
        </message>
        <message>
            <source>running</source>
            <translation>running</translation>
        </message>
        <message>
            <source>in progress</source>
            <translation>in progress</translation>
        </message>
        <message>
            <source>stopped early</source>
            <translation>stopped early</translation>
        </message>
        <message>
            <source>cuts surface</source>
            <translation>cuts surface</translation>
        </message>
        <message>
            <source>accepted</source>
            <translation>accepted</translation>
        </message>
        <message>
            <source>failed</source>
            <translation>failed</translation>
        </message>
        <message>
            <source>Not filled yet.</source>
            <translation>Not filled yet.</translation>
        </message>
        <message>
            <source>Not filled unless you select it yourself.</source>
            <translation>Not filled unless you select it yourself.</translation>
        </message>
        <message>
            <source>A flow is moving this patch now.</source>
            <translation>A flow is moving this patch now.</translation>
        </message>
        <message>
            <source>A flow has moved this patch; more steps can be taken.</source>
            <translation>A flow has moved this patch; more steps can be taken.</translation>
        </message>
        <message>
            <source>This patch cuts the surface or itself. It is not exported unless you accept it.</source>
            <translation>This patch cuts the surface or itself. It is not exported unless you accept it.</translation>
        </message>
        <message>
            <source>Accepted: no flow moves it until you open it again.</source>
            <translation>Accepted: no flow moves it until you open it again.</translation>
        </message>
        <message>
            <source>This hole could not be filled.</source>
            <translation>This hole could not be filled.</translation>
        </message>
        <message>
            <source>MMCVF – curvature</source>
            <translation>MMCVF – curvature</translation>
        </message>
        <message>
            <source>WF – tangent, round</source>
            <translation>WF – tangent, round</translation>
        </message>
        <message>
            <source>SDF – tangent, taut</source>
            <translation>SDF – tangent, taut</translation>
        </message>
        <message>
            <source>MCF – position, soap film</source>
            <translation>MCF – position, soap film</translation>
        </message>
        <message>
            <source>Minimal mean-curvature variation, sixth order: position, tangent and curvature match at the seam.</source>
            <translation>Minimal mean-curvature variation, sixth order: position, tangent and curvature match at the seam.</translation>
        </message>
        <message>
            <source>Willmore flow, fourth order: position and tangent match; bends as little as possible.</source>
            <translation>Willmore flow, fourth order: position and tangent match; bends as little as possible.</translation>
        </message>
        <message>
            <source>Surface diffusion, fourth order: position and tangent match; mean curvature spreads evenly.</source>
            <translation>Surface diffusion, fourth order: position and tangent match; mean curvature spreads evenly.</translation>
        </message>
        <message>
            <source>Mean curvature flow, second order: least area; a crease stays at the seam.</source>
            <translation>Mean curvature flow, second order: least area; a crease stays at the seam.</translation>
        </message>
        <message>
            <source>Tangent and curvature run through the seam.</source>
            <translation>Tangent and curvature run through the seam.</translation>
        </message>
        <message>
            <source>The patch meets the scan with a crease of %1° (rms).</source>
            <translation>The patch meets the scan with a crease of %1° (rms).</translation>
        </message>
        <message>
            <source>The tangent runs through the seam; the mean curvature jumps by %1 (rms).</source>
            <translation>The tangent runs through the seam; the mean curvature jumps by %1 (rms).</translation>
        </message>
        <message>
            <source>No flow has run yet.</source>
            <translation>No flow has run yet.</translation>
        </message>
        <message>
            <source>The flow made the jump of curvature %1 times smaller.</source>
            <translation>The flow made the jump of curvature %1 times smaller.</translation>
        </message>
        <message>
            <source>%1 of %2</source>
            <translation>%1 of %2</translation>
        </message>
        <message>
            <source>hole %1</source>
            <translation>hole %1</translation>
        </message>
        <message>
            <source>%1 holes</source>
            <translation>%1 holes</translation>
        </message>
        <message>
            <source>holes %1 and %2</source>
            <translation>holes %1 and %2</translation>
        </message>
        <message>
            <source>%1: %2 triangles, %3 vertices, %4 boundary loops.</source>
            <translation>%1: %2 triangles, %3 vertices, %4 boundary loops.</translation>
        </message>
        <message>
            <source>%1 polygons cut into triangles</source>
            <translation>%1 polygons cut into triangles</translation>
        </message>
        <message>
            <source>%1 faces turned round</source>
            <translation>%1 faces turned round</translation>
        </message>
        <message>
            <source>%1 degenerate faces left aside</source>
            <translation>%1 degenerate faces left aside</translation>
        </message>
        <message>
            <source>%1 duplicate faces left aside</source>
            <translation>%1 duplicate faces left aside</translation>
        </message>
        <message>
            <source>cut along %1 non-manifold edges</source>
            <translation>cut along %1 non-manifold edges</translation>
        </message>
        <message>
            <source>split at %1 non-manifold vertices</source>
            <translation>split at %1 non-manifold vertices</translation>
        </message>
        <message>
            <source>%1 vertices that no face uses</source>
            <translation>%1 vertices that no face uses</translation>
        </message>
        <message>
            <source>Noted: %1.</source>
            <translation>Noted: %1.</translation>
        </message>
        <message>
            <source>converged</source>
            <translation>converged</translation>
        </message>
        <message>
            <source>faired</source>
            <translation>faired</translation>
        </message>
        <message>
            <source>doubtful</source>
            <translation>doubtful</translation>
        </message>
        <message>
            <source>The flow has converged to its steady state.</source>
            <translation>The flow has converged to its steady state.</translation>
        </message>
        <message>
            <source>Shaped by linear fairing, not by the flow.</source>
            <translation>Shaped by linear fairing, not by the flow.</translation>
        </message>
        <message>
            <source>Filled, but the patch is out of proportion to its hole: look at it.</source>
            <translation>Filled, but the patch is out of proportion to its hole: look at it.</translation>
        </message>
        <message>
            <source>The flow stopped before it converged; this is its last good state.</source>
            <translation>The flow stopped before it converged; this is its last good state.</translation>
        </message>
        <message>
            <source>But the patch is out of proportion to its hole.</source>
            <translation>But the patch is out of proportion to its hole.</translation>
        </message>
        <message>
            <source>Fairing made the jump of curvature %1 times smaller.</source>
            <translation>Fairing made the jump of curvature %1 times smaller.</translation>
        </message>
        <message>
            <source>smooth</source>
            <translation>smooth</translation>
        </message>
        <message>
            <source>noisy</source>
            <translation>noisy</translation>
        </message>
        <message>
            <source>rough</source>
            <translation>rough</translation>
        </message>
        <message>
            <source>What smooth fits leave over of the scan's vertices around the hole is %1, or %2 % of an edge. The fits tell the normal at the rim to %3° and the mean curvature to %4 (it is %5 there, rms); the band in the section shows it.</source>
            <translation>What smooth fits leave over of the scan's vertices around the hole is %1, or %2 % of an edge. The fits tell the normal at the rim to %3° and the mean curvature to %4 (it is %5 there, rms); the band in the section shows it.</translation>
        </message>
        <message>
            <source>%1 vertices without a colour, made white</source>
            <translation>%1 vertices without a colour, made white</translation>
        </message>
        <message>
            <source>%1 boundary edges that lie exactly on another (the mesh is split there; `loopmend fill --weld` joins them)</source>
            <translation>%1 boundary edges that lie exactly on another (the mesh is split there; `loopmend fill --weld` joins them)</translation>
        </message>
        <message>
            <source>Will not be saved: %1.</source>
            <translation>Will not be saved: %1.</translation>
        </message>
        <message>
            <source>normals</source>
            <translation>normals</translation>
        </message>
        <message>
            <source>face normals</source>
            <translation>face normals</translation>
        </message>
        <message>
            <source>texture coordinates</source>
            <translation>texture coordinates</translation>
        </message>
        <message>
            <source>texture coordinates of faces</source>
            <translation>texture coordinates of faces</translation>
        </message>
        <message>
            <source>face colours</source>
            <translation>face colours</translation>
        </message>
        <message>
            <source>vertex colours</source>
            <translation>vertex colours</translation>
        </message>
        <message>
            <source>alpha values</source>
            <translation>alpha values</translation>
        </message>
        <message>
            <source>vertices without faces</source>
            <translation>vertices without faces</translation>
        </message>
        <message>
            <source>materials</source>
            <translation>materials</translation>
        </message>
        <message>
            <source>material libraries</source>
            <translation>material libraries</translation>
        </message>
        <message>
            <source>objects</source>
            <translation>objects</translation>
        </message>
        <message>
            <source>groups</source>
            <translation>groups</translation>
        </message>
        <message>
            <source>smoothing groups</source>
            <translation>smoothing groups</translation>
        </message>
        <message>
            <source>lines</source>
            <translation>lines</translation>
        </message>
        <message>
            <source>points</source>
            <translation>points</translation>
        </message>
        <message>
            <source>Closed by the initial patch; no flow has run yet.</source>
            <translation>Closed by the initial patch; no flow has run yet.</translation>
        </message>
    </context>
</TS>
