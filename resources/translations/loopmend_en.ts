<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
    <context>
        <name>loopmend::Autosave</name>
        <message numerus="yes">
            <source>%1, %n patch(es), %2</source>
            <translation>
                <numerusform>%1, %n patch, %2</numerusform>
                <numerusform>%1, %n patches, %2</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>loopmend::ExportDialog</name>
        <message numerus="yes">
            <source>%n hidden piece(s) or patch(es) are written as well.</source>
            <translation>
                <numerusform>%n hidden piece or patch is written as well.</numerusform>
                <numerusform>%n hidden pieces or patches are written as well.</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>loopmend::FileDesk</name>
        <message numerus="yes">
            <source>%n of the patches are initial patches: no flow has smoothed them yet.</source>
            <translation>
                <numerusform>%n of the patches is an initial patch: no flow has smoothed it yet.</numerusform>
                <numerusform>%n of the patches are initial patches: no flow has smoothed them yet.</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>loopmend::FillBox</name>
        <message numerus="yes">
            <source>%n crack(s): press Stitch.</source>
            <translation>
                <numerusform>%n crack: press Stitch.</numerusform>
                <numerusform>%n cracks: press Stitch.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n cut(s): press Repair….</source>
            <translation>
                <numerusform>%n cut: press Repair….</numerusform>
                <numerusform>%n cuts: press Repair….</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>Stitch %n crack(s)</source>
            <translation>
                <numerusform>Stitch %n crack</numerusform>
                <numerusform>Stitch %n cracks</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>loopmend::FillController</name>
        <message numerus="yes">
            <source>%n more</source>
            <translation>
                <numerusform>%n more</numerusform>
                <numerusform>%n more</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n vertices joined</source>
            <translation>
                <numerusform>%n vertex joined</numerusform>
                <numerusform>%n vertices joined</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n degenerate faces removed</source>
            <translation>
                <numerusform>%n degenerate face removed</numerusform>
                <numerusform>%n degenerate faces removed</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n duplicate faces removed</source>
            <translation>
                <numerusform>%n duplicate face removed</numerusform>
                <numerusform>%n duplicate faces removed</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n intersecting faces cut out</source>
            <translation>
                <numerusform>%n intersecting face cut out</numerusform>
                <numerusform>%n intersecting faces cut out</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n edges separated</source>
            <translation>
                <numerusform>%n edge separated</numerusform>
                <numerusform>%n edges separated</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n vertices separated</source>
            <translation>
                <numerusform>%n vertex separated</numerusform>
                <numerusform>%n vertices separated</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n faces turned</source>
            <translation>
                <numerusform>%n face turned</numerusform>
                <numerusform>%n faces turned</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n loose crumbs removed</source>
            <translation>
                <numerusform>%n loose crumb removed</numerusform>
                <numerusform>%n loose crumbs removed</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n patch(es) are a part of the scan now.</source>
            <translation>
                <numerusform>%n patch is a part of the scan now.</numerusform>
                <numerusform>%n patches are a part of the scan now.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1 %n patch(es) of this scan were removed.</source>
            <translation>
                <numerusform>%1 %n patch of this scan was removed.</numerusform>
                <numerusform>%1 %n patches of this scan were removed.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1: %n face(s) were erased; Ctrl+Z brings them back.</source>
            <translation>
                <numerusform>%1: %n face was erased; Ctrl+Z brings it back.</numerusform>
                <numerusform>%1: %n faces were erased; Ctrl+Z brings them back.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1: the boundary was parted at %n vertices; Ctrl+Z takes it back.</source>
            <translation>
                <numerusform>%1: the boundary was parted at %n vertex; Ctrl+Z takes it back.</numerusform>
                <numerusform>%1: the boundary was parted at %n vertices; Ctrl+Z takes it back.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1: %n triangle(s) were removed where a boundary ran through the surface; Ctrl+Z brings them back.</source>
            <translation>
                <numerusform>%1: %n triangle was removed where a boundary ran through the surface; Ctrl+Z brings it back.</numerusform>
                <numerusform>%1: %n triangles were removed where a boundary ran through the surface; Ctrl+Z brings them back.</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>loopmend::HolesPanel</name>
        <message numerus="yes">
            <source>%n hole(s), %1 open</source>
            <translation>
                <numerusform>%n hole, %1 open</numerusform>
                <numerusform>%n holes, %1 open</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>loopmend::MainWindow</name>
        <message numerus="yes">
            <source>Stitc&amp;h %n crack(s)</source>
            <translation>
                <numerusform>Stitc&amp;h %n crack</numerusform>
                <numerusform>Stitc&amp;h %n cracks</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>loopmend::MeshView</name>
        <message numerus="yes">
            <source>%n hidden: show all</source>
            <translation>
                <numerusform>%n hidden: show all</numerusform>
                <numerusform>%n hidden: show all</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>loopmend::PieceMenu</name>
        <message numerus="yes">
            <source>%n piece(s)</source>
            <translation>
                <numerusform>%n piece</numerusform>
                <numerusform>%n pieces</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>loopmend::ScenePanel</name>
        <message numerus="yes">
            <source>%n smaller piece(s)</source>
            <translation>
                <numerusform>%n smaller piece</numerusform>
                <numerusform>%n smaller pieces</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n patch(es)</source>
            <translation>
                <numerusform>%n patch</numerusform>
                <numerusform>%n patches</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>loopmend::StatusLine</name>
        <message numerus="yes">
            <source>Not watertight: %n open boundary loop(s)</source>
            <translation>
                <numerusform>Not watertight: %n open boundary loop</numerusform>
                <numerusform>Not watertight: %n open boundary loops</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>Watertight but for %n crack(s): press Stitch</source>
            <translation>
                <numerusform>Watertight but for %n crack: press Stitch</numerusform>
                <numerusform>Watertight but for %n cracks: press Stitch</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>loopmend::labels</name>
        <message numerus="yes">
            <source>%n open boundary loop(s)</source>
            <translation>
                <numerusform>%n open boundary loop</numerusform>
                <numerusform>%n open boundary loops</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n edge(s) of more than two faces</source>
            <translation>
                <numerusform>%n edge of more than two faces</numerusform>
                <numerusform>%n edges of more than two faces</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n edge(s) whose faces look to opposite sides</source>
            <translation>
                <numerusform>%n edge whose faces look to opposite sides</numerusform>
                <numerusform>%n edges whose faces look to opposite sides</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n pair(s) of faces that intersect</source>
            <translation>
                <numerusform>%n pair of faces that intersect</numerusform>
                <numerusform>%n pairs of faces that intersect</numerusform>
            </translation>
        </message>
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
    </context>
</TS>
