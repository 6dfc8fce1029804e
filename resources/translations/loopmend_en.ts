<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
    <context>
        <name>loopmend::Autosave</name>
        <message numerus="yes">
            <source>%1, %Ln patch(es), %2</source>
            <translation>
                <numerusform>%1, %Ln patch, %2</numerusform>
                <numerusform>%1, %Ln patches, %2</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>loopmend::ExportDialog</name>
        <message numerus="yes">
            <source>%Ln hidden piece(s) or patch(es) are written as well.</source>
            <translation>
                <numerusform>%Ln hidden piece or patch is written as well.</numerusform>
                <numerusform>%Ln hidden pieces or patches are written as well.</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>loopmend::FileController</name>
        <message numerus="yes">
            <source>%Ln hole(s) closed by an initial patch: no flow has smoothed it yet.</source>
            <translation>
                <numerusform>%Ln hole is closed by an initial patch: no flow has smoothed it yet.</numerusform>
                <numerusform>%Ln holes are closed by initial patches: no flow has smoothed them yet.</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>loopmend::FillBox</name>
        <message numerus="yes">
            <source>%Ln crack(s): press Stitch.</source>
            <translation>
                <numerusform>%Ln crack: press Stitch.</numerusform>
                <numerusform>%Ln cracks: press Stitch.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>Stitch %Ln crack(s)</source>
            <translation>
                <numerusform>Stitch %Ln crack</numerusform>
                <numerusform>Stitch %Ln cracks</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln patch(es) cut the surface.</source>
            <translation>
                <numerusform>%Ln patch cuts the surface.</numerusform>
                <numerusform>%Ln patches cut the surface.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln cut(s): press Repair…</source>
            <translation>
                <numerusform>%Ln cut: press Repair…</numerusform>
                <numerusform>%Ln cuts: press Repair…</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>loopmend::FillController</name>
        <message numerus="yes">
            <source>%Ln more</source>
            <translation>
                <numerusform>%Ln more</numerusform>
                <numerusform>%Ln more</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln patch(es) are a part of the scan now.</source>
            <translation>
                <numerusform>%Ln patch is a part of the scan now.</numerusform>
                <numerusform>%Ln patches are a part of the scan now.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1 %Ln patch(es) of this scan were removed.</source>
            <translation>
                <numerusform>%1 %Ln patch of this scan was removed.</numerusform>
                <numerusform>%1 %Ln patches of this scan were removed.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1: %Ln triangle(s) were removed where a boundary ran through the surface; Ctrl+Z brings them back.</source>
            <translation>
                <numerusform>%1: %Ln triangle was removed where a boundary ran through the surface; Ctrl+Z brings it back.</numerusform>
                <numerusform>%1: %Ln triangles were removed where a boundary ran through the surface; Ctrl+Z brings them back.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln vertices joined</source>
            <translation>
                <numerusform>%Ln vertex joined</numerusform>
                <numerusform>%Ln vertices joined</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln degenerate faces removed</source>
            <translation>
                <numerusform>%Ln degenerate face removed</numerusform>
                <numerusform>%Ln degenerate faces removed</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln duplicate faces removed</source>
            <translation>
                <numerusform>%Ln duplicate face removed</numerusform>
                <numerusform>%Ln duplicate faces removed</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln intersecting faces cut out</source>
            <translation>
                <numerusform>%Ln intersecting face cut out</numerusform>
                <numerusform>%Ln intersecting faces cut out</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln edges separated</source>
            <translation>
                <numerusform>%Ln edge separated</numerusform>
                <numerusform>%Ln edges separated</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln vertices separated</source>
            <translation>
                <numerusform>%Ln vertex separated</numerusform>
                <numerusform>%Ln vertices separated</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln faces turned</source>
            <translation>
                <numerusform>%Ln face turned</numerusform>
                <numerusform>%Ln faces turned</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln loose crumbs removed</source>
            <translation>
                <numerusform>%Ln loose crumb removed</numerusform>
                <numerusform>%Ln loose crumbs removed</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1: %Ln face(s) were erased; Ctrl+Z brings them back.</source>
            <translation>
                <numerusform>%1: %Ln face was erased; Ctrl+Z brings it back.</numerusform>
                <numerusform>%1: %Ln faces were erased; Ctrl+Z brings them back.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1: the boundary was parted at %Ln vertices; Ctrl+Z takes it back.</source>
            <translation>
                <numerusform>%1: the boundary was parted at %Ln vertex; Ctrl+Z takes it back.</numerusform>
                <numerusform>%1: the boundary was parted at %Ln vertices; Ctrl+Z takes it back.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln tiny handles cut open</source>
            <translation>
                <numerusform>%Ln tiny handle cut open</numerusform>
                <numerusform>%Ln tiny handles cut open</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>loopmend::HolesPanel</name>
        <message numerus="yes">
            <source>%Ln hole(s), %L1 open</source>
            <translation>
                <numerusform>%Ln hole, %L1 open</numerusform>
                <numerusform>%Ln holes, %L1 open</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>loopmend::MainWindow</name>
        <message numerus="yes">
            <source>Stitc&amp;h %Ln crack(s)</source>
            <translation>
                <numerusform>Stitc&amp;h %Ln crack</numerusform>
                <numerusform>Stitc&amp;h %Ln cracks</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>loopmend::MeshView</name>
        <message numerus="yes">
            <source>%Ln hidden: show all</source>
            <translation>
                <numerusform>%Ln hidden: show all</numerusform>
                <numerusform>%Ln hidden: show all</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>loopmend::PieceMenu</name>
        <message numerus="yes">
            <source>%Ln piece(s)</source>
            <translation>
                <numerusform>%Ln piece</numerusform>
                <numerusform>%Ln pieces</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>loopmend::ScenePanel</name>
        <message numerus="yes">
            <source>%Ln smaller piece(s)</source>
            <translation>
                <numerusform>%Ln smaller piece</numerusform>
                <numerusform>%Ln smaller pieces</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln patch(es)</source>
            <translation>
                <numerusform>%Ln patch</numerusform>
                <numerusform>%Ln patches</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>loopmend::StatusLine</name>
        <message numerus="yes">
            <source>Watertight but for %Ln crack(s): press Stitch</source>
            <translation>
                <numerusform>Watertight but for %Ln crack: press Stitch</numerusform>
                <numerusform>Watertight but for %Ln cracks: press Stitch</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>Not watertight: %Ln open boundary loop(s)</source>
            <translation>
                <numerusform>Not watertight: %Ln open boundary loop</numerusform>
                <numerusform>Not watertight: %Ln open boundary loops</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>loopmend::labels</name>
        <message numerus="yes">
            <source>%1 triangles</source>
            <translation>
                <numerusform>%1 triangle</numerusform>
                <numerusform>%1 triangles</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1 vertices</source>
            <translation>
                <numerusform>%1 vertex</numerusform>
                <numerusform>%1 vertices</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1 boundary loops</source>
            <translation>
                <numerusform>%1 boundary loop</numerusform>
                <numerusform>%1 boundary loops</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1 polygons cut into triangles</source>
            <translation>
                <numerusform>%1 polygon cut into triangles</numerusform>
                <numerusform>%1 polygons cut into triangles</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1 faces turned round</source>
            <translation>
                <numerusform>%1 face turned round</numerusform>
                <numerusform>%1 faces turned round</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1 degenerate faces left aside</source>
            <translation>
                <numerusform>%1 degenerate face left aside</numerusform>
                <numerusform>%1 degenerate faces left aside</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1 duplicate faces left aside</source>
            <translation>
                <numerusform>%1 duplicate face left aside</numerusform>
                <numerusform>%1 duplicate faces left aside</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>cut along %1 non-manifold edges</source>
            <translation>
                <numerusform>cut along %1 non-manifold edge</numerusform>
                <numerusform>cut along %1 non-manifold edges</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>split at %1 non-manifold vertices</source>
            <translation>
                <numerusform>split at %1 non-manifold vertex</numerusform>
                <numerusform>split at %1 non-manifold vertices</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1 touching boundary vertices joined</source>
            <translation>
                <numerusform>%1 touching boundary vertex joined</numerusform>
                <numerusform>%1 touching boundary vertices joined</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1 vertices that no face uses</source>
            <translation>
                <numerusform>%1 vertex that no face uses</numerusform>
                <numerusform>%1 vertices that no face uses</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1 vertices without a colour, made white</source>
            <translation>
                <numerusform>%1 vertex without a colour, made white</numerusform>
                <numerusform>%1 vertices without a colour, made white</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1 boundary edges that lie exactly on another (the mesh is split there; Stitch joins them)</source>
            <translation>
                <numerusform>%1 boundary edge that lies exactly on another (the mesh is split there; Stitch joins them)</numerusform>
                <numerusform>%1 boundary edges that lie exactly on another (the mesh is split there; Stitch joins them)</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln open boundary loop(s)</source>
            <translation>
                <numerusform>%Ln open boundary loop</numerusform>
                <numerusform>%Ln open boundary loops</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln edge(s) of more than two faces</source>
            <translation>
                <numerusform>%Ln edge of more than two faces</numerusform>
                <numerusform>%Ln edges of more than two faces</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln edge(s) whose faces look to opposite sides</source>
            <translation>
                <numerusform>%Ln edge whose faces look to opposite sides</numerusform>
                <numerusform>%Ln edges whose faces look to opposite sides</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln pair(s) of faces that intersect</source>
            <translation>
                <numerusform>%Ln pair of faces that intersect</numerusform>
                <numerusform>%Ln pairs of faces that intersect</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln piece(s) of surface</source>
            <translation>
                <numerusform>%Ln piece of surface</numerusform>
                <numerusform>%Ln pieces of surface</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln edge(s) along which it touches itself</source>
            <translation>
                <numerusform>%Ln edge along which it touches itself</numerusform>
                <numerusform>%Ln edges along which it touches itself</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1 vertices joined along cracks no wider than rounding</source>
            <translation>
                <numerusform>%1 vertex joined along cracks no wider than rounding</numerusform>
                <numerusform>%1 vertices joined along cracks no wider than rounding</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>crosses the surface or itself in %Ln place(s)</source>
            <translation>
                <numerusform>crosses the surface or itself in %Ln place</numerusform>
                <numerusform>crosses the surface or itself in %Ln places</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln edge(s) folded by more than 150°</source>
            <translation>
                <numerusform>%Ln edge folded by more than 150°</numerusform>
                <numerusform>%Ln edges folded by more than 150°</numerusform>
            </translation>
        </message>
    </context>
</TS>
