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
        <name>loopmend::FillController</name>
        <message numerus="yes">
            <source>%n more</source>
            <translation>
                <numerusform>%n more</numerusform>
                <numerusform>%n more</numerusform>
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
        <name>loopmend::StatusLine</name>
        <message numerus="yes">
            <source>Not watertight: %n open boundary loop(s)</source>
            <translation>
                <numerusform>Not watertight: %n open boundary loop</numerusform>
                <numerusform>Not watertight: %n open boundary loops</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>Not watertight: %n edge(s) of more than two faces</source>
            <translation>
                <numerusform>Not watertight: %n edge of more than two faces</numerusform>
                <numerusform>Not watertight: %n edges of more than two faces</numerusform>
            </translation>
        </message>
    </context>
</TS>
