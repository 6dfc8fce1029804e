<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
    <context>
        <name>loopmend</name>
        <message>
            <source>Reading the file</source>
            <translation>Die Datei wird gelesen</translation>
        </message>
        <message>
            <source>Sample</source>
            <translation>Beispiel</translation>
        </message>
        <message>
            <source>Looking for holes</source>
            <translation>Löcher werden gesucht</translation>
        </message>
        <message>
            <source>not known</source>
            <translation>nicht bekannt</translation>
        </message>
        <message>
            <source>Patch of %1</source>
            <translation>Flicken von %1</translation>
        </message>
        <message>
            <source>, vertex %1</source>
            <translation>, Ecke %1</translation>
        </message>
        <message>
            <source>%1 has patches: export it by itself as %2 before you use the command.</source>
            <translation>%1 hat Flicken: vor dem Befehl allein als %2 exportieren.</translation>
        </message>
        <message>
            <source>%1 was made in the window: export it by itself as %2 before you use the command.</source>
            <translation>%1 ist im Fenster entstanden: vor dem Befehl allein als %2 exportieren.</translation>
        </message>
        <message>
            <source>%1 was made in the window: export it as surface.ply, without patches, before you use the command.</source>
            <translation>%1 ist im Fenster entstanden: vor dem Befehl als surface.ply exportieren, ohne Flicken.</translation>
        </message>
        <message>
            <source>The command compares on all holes of the file, and on nothing else.</source>
            <translation>Der Befehl vergleicht auf allen Löchern der Datei und auf nichts sonst.</translation>
        </message>
        <message>
            <source>The command runs all four flows.</source>
            <translation>Der Befehl rechnet alle vier Flüsse.</translation>
        </message>
        <message>
            <source>The command line is in the clipboard.</source>
            <translation>Die Befehlszeile ist in der Zwischenablage.</translation>
        </message>
        <message>
            <source>Flow</source>
            <translation>Fluss</translation>
        </message>
        <message>
            <source>Boundary</source>
            <translation>Rand</translation>
        </message>
        <message>
            <source>How far MMCVF trusts the curvature of the scan around the hole</source>
            <translation>Wie weit MMCVF der Krümmung des Scans um das Loch traut</translation>
        </message>
        <message>
            <source>Auto</source>
            <translation>Auto</translation>
        </message>
        <message>
            <source>Exact</source>
            <translation>Exakt</translation>
        </message>
        <message>
            <source>As it is: the flow itself, also on rough scans.</source>
            <translation>So, wie sie ist: der Fluss selbst, auch auf rauen Scans.</translation>
        </message>
        <message>
            <source>Robust</source>
            <translation>Robust</translation>
        </message>
        <message>
            <source>Hardly: robust fairing in place of the flow.</source>
            <translation>Kaum: robuste Glättung statt des Flusses.</translation>
        </message>
        <message>
            <source>Continuity</source>
            <translation>Übergang</translation>
        </message>
        <message>
            <source>What MMCVF makes run through the seam</source>
            <translation>Was mit MMCVF stetig durch die Naht läuft</translation>
        </message>
        <message>
            <source>Curvature</source>
            <translation>Krümmung</translation>
        </message>
        <message>
            <source>Position, tangent and curvature: the flow itself.</source>
            <translation>Lage, Tangente und Krümmung: der Fluss selbst.</translation>
        </message>
        <message>
            <source>Tangent</source>
            <translation>Tangente</translation>
        </message>
        <message>
            <source>Position and tangent: linear fairing in place of the flow.</source>
            <translation>Lage und Tangente: lineare Glättung statt des Flusses.</translation>
        </message>
        <message>
            <source>Position</source>
            <translation>Lage</translation>
        </message>
        <message>
            <source>Position alone: a taut skin, with a crease at the seam.</source>
            <translation>Nur die Lage: eine gespannte Haut, mit einem Knick an der Naht.</translation>
        </message>
        <message>
            <source>Shading</source>
            <translation>Darstellung</translation>
        </message>
        <message>
            <source>Mean curvature H</source>
            <translation>Mittlere Krümmung H</translation>
        </message>
        <message>
            <source>Gaussian curvature K</source>
            <translation>Gaußsche Krümmung K</translation>
        </message>
        <message>
            <source>Plain</source>
            <translation>Schlicht</translation>
        </message>
        <message>
            <source>Zebra</source>
            <translation>Zebra</translation>
        </message>
        <message>
            <source>Isophotes</source>
            <translation>Isophoten</translation>
        </message>
        <message>
            <source>Its boundary loops have other numbers then: 'loopmend info' prints them.</source>
            <translation>Die Ränder haben dann andere Nummern: „loopmend info“ nennt sie.</translation>
        </message>
        <message>
            <source>As far as it can be trusted: the flow, on rough and noisy scans on the smooth surface under them.</source>
            <translation>Soweit man ihr trauen kann: der Fluss, auf rauen und verrauschten Scans auf der glatten Fläche darunter.</translation>
        </message>
    </context>
    <context>
        <name>loopmend::About</name>
        <message>
            <source>About Loopmend</source>
            <translation>Über Loopmend</translation>
        </message>
        <message>
            <source>&lt;h2&gt;Loopmend %1&lt;/h2&gt;&lt;p&gt;Closes holes in scanned meshes with patches whose curvature runs through the seam.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later: you may use, study, share and change it. It comes without any warranty.&lt;br&gt;&lt;a href="https://www.gnu.org/licenses/gpl-3.0.html"&gt;gnu.org/licenses/gpl-3.0&lt;/a&gt;&lt;/p&gt;&lt;p&gt;Built with Qt, VTK, QCustomPlot, Eigen, OpenMesh, CGAL and SuiteSparse.&lt;/p&gt;</source>
            <translation>&lt;h2&gt;Loopmend %1&lt;/h2&gt;&lt;p&gt;Schließt Löcher in gescannten Netzen mit Flicken, deren Krümmung durch die Naht läuft.&lt;/p&gt;&lt;p&gt;Freie Software unter der GNU General Public License, Version 3 oder später: benutzen, untersuchen, weitergeben und ändern erlaubt. Ohne jede Gewähr.&lt;br&gt;&lt;a href="https://www.gnu.org/licenses/gpl-3.0.html"&gt;gnu.org/licenses/gpl-3.0&lt;/a&gt;&lt;/p&gt;&lt;p&gt;Gebaut mit Qt, VTK, QCustomPlot, Eigen, OpenMesh, CGAL und SuiteSparse.&lt;/p&gt;</translation>
        </message>
    </context>
    <context>
        <name>loopmend::Autosave</name>
        <message>
            <source>The copy that would survive a crash could not be written: %1</source>
            <translation>Die Sicherungskopie konnte nicht geschrieben werden: %1</translation>
        </message>
        <message>
            <source>Sample</source>
            <translation>Beispiel</translation>
        </message>
        <message numerus="yes">
            <source>%1, %Ln patch(es), %2</source>
            <translation>
                <numerusform>%1, %Ln Flicken, %2</numerusform>
                <numerusform>%1, %Ln Flicken, %2</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>loopmend::Banner</name>
        <message>
            <source>Close</source>
            <translation>Schließen</translation>
        </message>
        <message>
            <source>Close this message (Esc)</source>
            <translation>Diese Meldung schließen (Esc)</translation>
        </message>
    </context>
    <context>
        <name>loopmend::BlendBox</name>
        <message>
            <source>Select of each part the loop that looks at the others most</source>
            <translation>Von jedem Teil den Rand auswählen, der am meisten zu den anderen blickt</translation>
        </message>
        <message>
            <source>Density</source>
            <translation>Dichte</translation>
        </message>
        <message>
            <source>Part to place</source>
            <translation>Teil zum Platzieren</translation>
        </message>
        <message>
            <source>This part gets a handle in the picture: arrows move it, rings turn it, the square scales it</source>
            <translation>Dieses Teil bekommt im Bild einen Griff: Pfeile verschieben, Ringe drehen, das Quadrat vergrößert</translation>
        </message>
        <message>
            <source>no part</source>
            <translation>kein Teil</translation>
        </message>
        <message>
            <source>Open the parts first.</source>
            <translation>Zuerst die Teile öffnen.</translation>
        </message>
        <message>
            <source>Only holes and outer rims can be joined, not a loop of the kind: %1.</source>
            <translation>Nur Löcher und Außenränder lassen sich verbinden, nicht ein Rand der Art: %1.</translation>
        </message>
        <message>
            <source>Selected: %1</source>
            <translation>Ausgewählt: %1</translation>
        </message>
        <message>
            <source>Select two or more boundaries, in the picture or in the table; Ctrl adds. One patch will join them.</source>
            <translation>Zwei oder mehr Ränder auswählen, im Bild oder in der Tabelle; Strg nimmt dazu. Ein Flicken verbindet sie.</translation>
        </message>
        <message>
            <source>Select at least two boundaries.</source>
            <translation>Mindestens zwei Ränder auswählen.</translation>
        </message>
        <message>
            <source>No boundary is selected.</source>
            <translation>Kein Rand ist ausgewählt.</translation>
        </message>
        <message>
            <source>A selected hole is filled: discard its patch first.</source>
            <translation>Ein ausgewähltes Loch ist gefüllt: zuerst seinen Flicken verwerfen.</translation>
        </message>
        <message>
            <source>Edges along a length, relative to the neighborhood</source>
            <translation>Kanten auf eine Länge, im Verhältnis zur Umgebung</translation>
        </message>
        <message>
            <source>Those that face each other</source>
            <translation>Die einander zugewandten</translation>
        </message>
        <message>
            <source>Place</source>
            <translation>Platzieren</translation>
        </message>
    </context>
    <context>
        <name>loopmend::ClippingBox</name>
        <message>
            <source>Clipping plane</source>
            <translation>Schnittebene</translation>
        </message>
        <message>
            <source>Off</source>
            <translation>Aus</translation>
        </message>
        <message>
            <source>Across the line of sight</source>
            <translation>Quer zur Blickrichtung</translation>
        </message>
        <message>
            <source>Across x</source>
            <translation>Quer zu x</translation>
        </message>
        <message>
            <source>Across y</source>
            <translation>Quer zu y</translation>
        </message>
        <message>
            <source>Across z</source>
            <translation>Quer zu z</translation>
        </message>
        <message>
            <source>Cut the surfaces open, to see them from inside (X). Nothing is removed from the scan</source>
            <translation>Die Flächen aufschneiden, um sie von innen zu sehen (X). Dem Scan wird nichts genommen</translation>
        </message>
        <message>
            <source>Place of the plane</source>
            <translation>Ort der Ebene</translation>
        </message>
        <message>
            <source>How far into the scene the plane lies</source>
            <translation>Wie tief in der Szene die Ebene liegt</translation>
        </message>
        <message>
            <source>Show the other side</source>
            <translation>Die andere Seite zeigen</translation>
        </message>
        <message>
            <source>Draw what lies before the plane in place of what lies behind it</source>
            <translation>Zeigen, was vor der Ebene liegt, statt dessen, was hinter ihr liegt</translation>
        </message>
    </context>
    <context>
        <name>loopmend::CompareController</name>
        <message>
            <source>There is no hole to compare flows on. Open a scan with holes, or pose a region, points or a bridge.</source>
            <translation>Es gibt kein Loch, an dem sich Flüsse vergleichen ließen. Einen Scan mit Löchern öffnen oder ein Gebiet, Punkte oder eine Brücke stellen.</translation>
        </message>
        <message>
            <source>The holes belong to several scans. Select holes of one of them.</source>
            <translation>Die Löcher gehören zu mehreren Scans. Löcher von einem davon auswählen.</translation>
        </message>
        <message>
            <source>%1 of %2</source>
            <translation>%1 von %2</translation>
        </message>
        <message>
            <source>Put this patch into the holes, in place of what is there; can be undone</source>
            <translation>Diesen Flicken in die Löcher setzen, anstelle dessen, was dort ist; lässt sich rückgängig machen</translation>
        </message>
        <message>
            <source>The scan of this comparison is no longer open.</source>
            <translation>Der Scan dieses Vergleichs ist nicht mehr offen.</translation>
        </message>
        <message>
            <source>The main window is busy. Try again when it is done.</source>
            <translation>Das Hauptfenster ist beschäftigt. Danach noch einmal versuchen.</translation>
        </message>
        <message>
            <source>%1 was applied in the main window; Ctrl+Z there undoes it.</source>
            <translation>%1 wurde ins Hauptfenster übernommen; Strg+Z dort nimmt es zurück.</translation>
        </message>
        <message>
            <source>Put this surface into the document, in place of what it came from; can be undone</source>
            <translation>Diese Fläche ins Dokument übernehmen, anstelle dessen, woraus sie entstand; lässt sich rückgängig machen</translation>
        </message>
    </context>
    <context>
        <name>loopmend::CompareNumbers</name>
        <message>
            <source>Surface</source>
            <translation>Fläche</translation>
        </message>
        <message>
            <source>End</source>
            <translation>Ende</translation>
        </message>
        <message>
            <source>Steps</source>
            <translation>Schritte</translation>
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
            <translation>Fläche</translation>
        </message>
        <message>
            <source>Wide jump</source>
            <translation>Weiter Sprung</translation>
        </message>
        <message>
            <source>Jump of H</source>
            <translation>Sprung von H</translation>
        </message>
        <message>
            <source>× diam.</source>
            <translation>× Durchm.</translation>
        </message>
        <message>
            <source>Angle, °</source>
            <translation>Winkel, °</translation>
        </message>
        <message>
            <source>Folds</source>
            <translation>Falten</translation>
        </message>
        <message>
            <source>Cuts</source>
            <translation>Schnitte</translation>
        </message>
        <message>
            <source>Which flow</source>
            <translation>Welcher Fluss</translation>
        </message>
        <message>
            <source>How the flow ended</source>
            <translation>Wie der Fluss endete</translation>
        </message>
        <message>
            <source>Accepted steps</source>
            <translation>Angenommene Schritte</translation>
        </message>
        <message>
            <source>What MMCVF lowers, in 1/length²</source>
            <translation>Was MMCVF senkt, in 1/Länge²</translation>
        </message>
        <message>
            <source>What WF lowers, without a unit</source>
            <translation>Was WF senkt, ohne Einheit</translation>
        </message>
        <message>
            <source>What MCF and SDF lower, in length²</source>
            <translation>Was MCF und SDF senken, in Länge²</translation>
        </message>
        <message>
            <source>Jump of H across the seam from wide one-sided fits, rms, in 1/length: the fairest figure between flows</source>
            <translation>Sprung von H an der Naht aus weiten einseitigen Anpassungen, quadratisches Mittel, in 1/Länge: die gerechteste Zahl zwischen Flüssen</translation>
        </message>
        <message>
            <source>Jump of H across the seam from narrow one-sided fits, rms, in 1/length</source>
            <translation>Sprung von H an der Naht aus engen einseitigen Anpassungen, quadratisches Mittel, in 1/Länge</translation>
        </message>
        <message>
            <source>The jump of H times the hole's diameter: without a unit</source>
            <translation>Der Sprung von H mal dem Durchmesser des Lochs: ohne Einheit</translation>
        </message>
        <message>
            <source>Angle between the normals of both sides at the seam, rms, in degrees</source>
            <translation>Winkel zwischen den Normalen beider Seiten an der Naht, quadratisches Mittel, in Grad</translation>
        </message>
        <message>
            <source>Edges folded by more than 90°</source>
            <translation>Kanten, die um mehr als 90° gefaltet sind</translation>
        </message>
        <message>
            <source>step limit</source>
            <translation>Schrittgrenze</translation>
        </message>
        <message>
            <source>stopped early</source>
            <translation>früh beendet</translation>
        </message>
        <message>
            <source>Energy of each flow against the step</source>
            <translation>Energie jedes Flusses über dem Schritt</translation>
        </message>
        <message>
            <source>Mean curvature across the seam, one line for each flow</source>
            <translation>Mittlere Krümmung quer zur Naht, eine Linie je Fluss</translation>
        </message>
        <message>
            <source>Figures of all flows</source>
            <translation>Zahlen aller Flüsse</translation>
        </message>
        <message>
            <source>Which energy</source>
            <translation>Welche Energie</translation>
        </message>
        <message>
            <source>Which energy the plot shows; each flow lowers its own</source>
            <translation>Welche Energie das Diagramm zeigt; jeder Fluss senkt seine eigene</translation>
        </message>
        <message>
            <source>∫|∇H|², what MMCVF lowers</source>
            <translation>∫|∇H|², was MMCVF senkt</translation>
        </message>
        <message>
            <source>∫H², what WF lowers</source>
            <translation>∫H², was WF senkt</translation>
        </message>
        <message>
            <source>Area, what MCF and SDF lower</source>
            <translation>Flächeninhalt, was MCF und SDF senken</translation>
        </message>
        <message>
            <source>H across the seam, patch right of 0</source>
            <translation>H quer zur Naht, Flicken rechts von 0</translation>
        </message>
        <message>
            <source>Start</source>
            <translation>Anfang</translation>
        </message>
        <message>
            <source>Run the flows, and their energies are drawn here.</source>
            <translation>Flüsse laufen lassen, und hier stehen ihre Energien.</translation>
        </message>
        <message>
            <source>There is no seam to look across.</source>
            <translation>Es gibt keine Naht, über die man blicken könnte.</translation>
        </message>
        <message>
            <source>converged</source>
            <translation>konvergiert</translation>
        </message>
        <message>
            <source>faired</source>
            <translation>geglättet</translation>
        </message>
        <message>
            <source>Places where the patch cuts itself or its neighborhood</source>
            <translation>Stellen, an denen der Flicken sich oder seine Umgebung schneidet</translation>
        </message>
        <message>
            <source>cuts surface</source>
            <translation>schneidet</translation>
        </message>
        <message>
            <source>filled</source>
            <translation>gefüllt</translation>
        </message>
        <message>
            <source>failed</source>
            <translation>misslungen</translation>
        </message>
        <message>
            <source>all steps taken</source>
            <translation>alle Schritte getan</translation>
        </message>
    </context>
    <context>
        <name>loopmend::CompareWindow</name>
        <message>
            <source>Wrote %1, and beside it energies and profile.</source>
            <translation>%1 geschrieben, daneben Energien und Profil.</translation>
        </message>
        <message>
            <source>Wrote %1.</source>
            <translation>%1 geschrieben.</translation>
        </message>
        <message>
            <source>Save numbers</source>
            <translation>Zahlen speichern</translation>
        </message>
        <message>
            <source>CSV (*.csv)</source>
            <translation>CSV (*.csv)</translation>
        </message>
        <message>
            <source>Compare flows: %1</source>
            <translation>Flüsse vergleichen: %1</translation>
        </message>
        <message>
            <source>&amp;Run all</source>
            <translation>A&amp;lle starten</translation>
        </message>
        <message>
            <source>All flows from the same start, side by side (Space)</source>
            <translation>Alle Flüsse vom selben Anfang, nebeneinander (Leertaste)</translation>
        </message>
        <message>
            <source>&amp;Stop</source>
            <translation>&amp;Halt</translation>
        </message>
        <message>
            <source>Stop at once; what was reached stays (Esc)</source>
            <translation>Sofort anhalten; das Erreichte bleibt (Esc)</translation>
        </message>
        <message>
            <source>Number of views</source>
            <translation>Zahl der Bilder</translation>
        </message>
        <message>
            <source>How many flows are compared</source>
            <translation>Wie viele Flüsse verglichen werden</translation>
        </message>
        <message>
            <source>%1 views</source>
            <translation>%1 Bilder</translation>
        </message>
        <message>
            <source>To the steady state</source>
            <translation>Bis zur Ruhe</translation>
        </message>
        <message>
            <source>Step by step</source>
            <translation>Schritt für Schritt</translation>
        </message>
        <message>
            <source>How</source>
            <translation>Wie</translation>
        </message>
        <message>
            <source>Time step</source>
            <translation>Zeitschritt</translation>
        </message>
        <message>
            <source>Time step σ, without a unit; the same for all flows</source>
            <translation>Zeitschritt σ, ohne Einheit; für alle Flüsse derselbe</translation>
        </message>
        <message>
            <source>Save &amp;picture…</source>
            <translation>&amp;Bild speichern…</translation>
        </message>
        <message>
            <source>All views as one PNG of a size you choose</source>
            <translation>Alle Bilder als ein PNG in gewählter Größe</translation>
        </message>
        <message>
            <source>Save &amp;numbers…</source>
            <translation>&amp;Zahlen speichern…</translation>
        </message>
        <message>
            <source>Table, energies and profiles as CSV, as loopmend compare writes them</source>
            <translation>Tabelle, Energien und Profile als CSV, wie loopmend compare sie schreibt</translation>
        </message>
        <message>
            <source>How all views are shown (keys 1 to 5)</source>
            <translation>Wie alle Bilder gezeigt werden (Tasten 1 bis 5)</translation>
        </message>
        <message>
            <source>&amp;Wireframe</source>
            <translation>&amp;Drahtgitter</translation>
        </message>
        <message>
            <source>Wireframe</source>
            <translation>Drahtgitter</translation>
        </message>
        <message>
            <source>Draw the triangles' edges</source>
            <translation>Die Kanten der Dreiecke zeichnen</translation>
        </message>
        <message>
            <source>C&amp;olours ±</source>
            <translation>&amp;Farben ±</translation>
        </message>
        <message>
            <source>Own range of colours</source>
            <translation>Eigener Farbbereich</translation>
        </message>
        <message>
            <source>Range</source>
            <translation>Bereich</translation>
        </message>
        <message>
            <source>The curvature at the ends of the colours</source>
            <translation>Die Krümmung an den Enden der Farben</translation>
        </message>
        <message>
            <source>&amp;Link views</source>
            <translation>Bilder &amp;koppeln</translation>
        </message>
        <message>
            <source>Link views</source>
            <translation>Bilder koppeln</translation>
        </message>
        <message>
            <source>Turning one view turns all</source>
            <translation>Ein Bild drehen dreht alle</translation>
        </message>
        <message>
            <source>&amp;Frame</source>
            <translation>&amp;Alles zeigen</translation>
        </message>
        <message>
            <source>See the whole patch in every view (F)</source>
            <translation>In jedem Bild den ganzen Flicken zeigen (F)</translation>
        </message>
        <message>
            <source>Wip&amp;e between</source>
            <translation>W&amp;ischen zwischen</translation>
        </message>
        <message>
            <source>Wipe</source>
            <translation>Wischen</translation>
        </message>
        <message>
            <source>One large picture of two flows, with a line between them that can be drawn</source>
            <translation>Ein großes Bild zweier Flüsse, dazwischen eine Linie zum Ziehen</translation>
        </message>
        <message>
            <source>Left of the line</source>
            <translation>Links der Linie</translation>
        </message>
        <message>
            <source>Which flow, or the start, is left of the line</source>
            <translation>Welcher Fluss, oder der Anfang, links der Linie ist</translation>
        </message>
        <message>
            <source>Right of the line</source>
            <translation>Rechts der Linie</translation>
        </message>
        <message>
            <source>Which flow, or the start, is right of the line</source>
            <translation>Welcher Fluss, oder der Anfang, rechts der Linie ist</translation>
        </message>
        <message>
            <source>Start</source>
            <translation>Anfang</translation>
        </message>
        <message>
            <source>σ = %1</source>
            <translation>σ = %1</translation>
        </message>
        <message>
            <source>Making the start…</source>
            <translation>Anfang wird gemacht…</translation>
        </message>
        <message>
            <source>Running…</source>
            <translation>Läuft…</translation>
        </message>
        <message>
            <source>%1 free vertices</source>
            <translation>%1 freie Ecken</translation>
        </message>
        <message>
            <source>Copy co&amp;mmand line</source>
            <translation>Be&amp;fehlszeile kopieren</translation>
        </message>
        <message>
            <source>Copy the commands that do the same</source>
            <translation>Die Befehle kopieren, die dasselbe tun</translation>
        </message>
        <message>
            <source>Straight to where each flow converges, or in time steps, as in the paper</source>
            <translation>Geradewegs dahin, wo jeder Fluss zur Ruhe kommt, oder in Zeitschritten wie im Aufsatz</translation>
        </message>
        <message>
            <source>A colour range of your own, instead of that of the neighborhood</source>
            <translation>Ein eigener Farbbereich anstelle dessen der Umgebung</translation>
        </message>
    </context>
    <context>
        <name>loopmend::DecisionBox</name>
        <message>
            <source>Timeline</source>
            <translation>Zeitleiste</translation>
        </message>
        <message>
            <source>Keep this patch as it is; no flow moves it any more (A)</source>
            <translation>Den Flicken so lassen; kein Fluss bewegt ihn mehr (A)</translation>
        </message>
        <message>
            <source>Throw this patch away; the hole is open again (Delete)</source>
            <translation>Den Flicken wegwerfen; das Loch ist wieder offen (Entf)</translation>
        </message>
        <message>
            <source>Copy the commands that fill these holes in just this way, for a terminal or a script</source>
            <translation>Die Befehle kopieren, die diese Löcher genau so füllen, für ein Terminal oder ein Skript</translation>
        </message>
        <message>
            <source>Recorded states appear here.</source>
            <translation>Hier erscheinen aufgezeichnete Zustände.</translation>
        </message>
        <message>
            <source>State %1 of %2: %3</source>
            <translation>Zustand %1 von %2: %3</translation>
        </message>
        <message>
            <source>Open again</source>
            <translation>Wieder öffnen</translation>
        </message>
        <message>
            <source>Accept</source>
            <translation>Annehmen</translation>
        </message>
        <message>
            <source>Let a flow move this patch again (A)</source>
            <translation>Den Flicken wieder von einem Fluss bewegen lassen (A)</translation>
        </message>
        <message>
            <source>step %1</source>
            <translation>Schritt %1</translation>
        </message>
        <message>
            <source>the initial patch</source>
            <translation>die erste Fläche</translation>
        </message>
        <message>
            <source>Go back to any recorded state, from the initial patch on the left to the latest</source>
            <translation>Zu jedem aufgezeichneten Zustand zurück, von der ersten Fläche links bis zum letzten</translation>
        </message>
        <message>
            <source>3  Review, decide</source>
            <translation>3  Zurückschauen, entscheiden</translation>
        </message>
        <message>
            <source>Discard</source>
            <translation>Verwerfen</translation>
        </message>
        <message>
            <source>Copy command line</source>
            <translation>Befehlszeile kopieren</translation>
        </message>
    </context>
    <context>
        <name>loopmend::EnergyView</name>
        <message>
            <source>Energy ∫|∇H|², 1/length²</source>
            <translation>Energie ∫|∇H|², 1/Länge²</translation>
        </message>
        <message>
            <source>Energy ∫H²</source>
            <translation>Energie ∫H²</translation>
        </message>
        <message>
            <source>Area, length²</source>
            <translation>Fläche, Länge²</translation>
        </message>
        <message>
            <source>Energy and residual against the step</source>
            <translation>Energie und Rest über den Schritten</translation>
        </message>
        <message>
            <source>Energy</source>
            <translation>Energie</translation>
        </message>
        <message>
            <source>Run a flow, and its energy is drawn here.</source>
            <translation>Sobald ein Fluss läuft, steht hier seine Energie.</translation>
        </message>
        <message>
            <source>relief and noise</source>
            <translation>Relief und Rauschen</translation>
        </message>
        <message>
            <source>Residual (right)</source>
            <translation>Rest (rechts)</translation>
        </message>
        <message>
            <source>J, lowered</source>
            <translation>J, sinkt</translation>
        </message>
        <message>
            <source>smooth part</source>
            <translation>glatter Teil</translation>
        </message>
    </context>
    <context>
        <name>loopmend::EngineTemplates</name>
        <message>
            <source>there is no such file</source>
            <translation>diese Datei gibt es nicht</translation>
        </message>
        <message>
            <source>Check the spelling and the folder</source>
            <translation>Schreibweise und Ordner prüfen</translation>
        </message>
        <message>
            <source>no permission to read this file</source>
            <translation>keine Berechtigung, diese Datei zu lesen</translation>
        </message>
        <message>
            <source>Change its permissions, or read a copy</source>
            <translation>Ihre Berechtigungen ändern oder eine Kopie lesen</translation>
        </message>
        <message>
            <source>Check the path and its permissions</source>
            <translation>Pfad und Berechtigungen prüfen</translation>
        </message>
        <message>
            <source>cannot be read</source>
            <translation>lässt sich nicht lesen</translation>
        </message>
        <message>
            <source>is a folder, not a file</source>
            <translation>ist ein Ordner, keine Datei</translation>
        </message>
        <message>
            <source>Choose a file inside it</source>
            <translation>Eine Datei darin wählen</translation>
        </message>
        <message>
            <source>is not a regular file</source>
            <translation>ist keine gewöhnliche Datei</translation>
        </message>
        <message>
            <source>Copy its content to a file first</source>
            <translation>Erst ihren Inhalt in eine Datei kopieren</translation>
        </message>
        <message>
            <source>the file is empty (0 bytes)</source>
            <translation>die Datei ist leer (0 Bytes)</translation>
        </message>
        <message>
            <source>Export or copy the mesh again</source>
            <translation>Das Netz noch einmal exportieren oder kopieren</translation>
        </message>
        <message>
            <source>this is a Git LFS pointer, not the mesh itself</source>
            <translation>dies ist ein Zeiger von Git LFS, nicht das Netz selbst</translation>
        </message>
        <message>
            <source>Run `git lfs pull` in its repository to fetch the mesh</source>
            <translation>In seinem Repositorium „git lfs pull“ ausführen, um das Netz zu holen</translation>
        </message>
        <message>
            <source>the text is encoded as UTF-16</source>
            <translation>der Text ist in UTF-16 kodiert</translation>
        </message>
        <message>
            <source>Save it as UTF-8 or plain ASCII</source>
            <translation>Ihn als UTF-8 oder reines ASCII speichern</translation>
        </message>
        <message>
            <source>does not begin with "solid" as text STL files do, and is not binary</source>
            <translation>beginnt nicht mit „solid“ wie STL-Dateien in Textform und ist nicht binär</translation>
        </message>
        <message>
            <source>does not begin with "ply" as every PLY file does</source>
            <translation>beginnt nicht mit „ply“ wie jede PLY-Datei</translation>
        </message>
        <message>
            <source>does not begin with "ply"</source>
            <translation>beginnt nicht mit „ply“</translation>
        </message>
        <message>
            <source>does not begin with "OFF" as OFF files do</source>
            <translation>beginnt nicht mit „OFF“ wie OFF-Dateien</translation>
        </message>
        <message>
            <source>does not begin as %1 files do</source>
            <translation>beginnt nicht wie %1-Dateien</translation>
        </message>
        <message>
            <source>The file is damaged or is something else under this name</source>
            <translation>Die Datei ist beschädigt oder unter diesem Namen etwas anderes</translation>
        </message>
        <message>
            <source>this is not a mesh format that Loopmend knows</source>
            <translation>dieses Format kennt Loopmend nicht</translation>
        </message>
        <message>
            <source>It reads PLY, STL, OBJ, OFF, glTF and 3MF files</source>
            <translation>Es liest Dateien der Formate PLY, STL, OBJ, OFF, glTF und 3MF</translation>
        </message>
        <message>
            <source>the mesh is too large for the memory of this computer</source>
            <translation>das Netz ist zu groß für den Speicher dieses Rechners</translation>
        </message>
        <message>
            <source>Close other programs, or reduce it</source>
            <translation>Andere Programme schließen oder das Netz verkleinern</translation>
        </message>
        <message>
            <source>the mesh is too large for this program</source>
            <translation>das Netz ist zu groß für dieses Programm</translation>
        </message>
        <message>
            <source>Reduce it first</source>
            <translation>Es zuerst verkleinern</translation>
        </message>
        <message>
            <source>holds no points and no faces</source>
            <translation>enthält keine Punkte und keine Flächen</translation>
        </message>
        <message>
            <source>holds points but no faces</source>
            <translation>enthält Punkte, aber keine Flächen</translation>
        </message>
        <message>
            <source>Loopmend needs a surface</source>
            <translation>Loopmend braucht eine Fläche</translation>
        </message>
        <message>
            <source>export the mesh together with its faces</source>
            <translation>das Netz mit seinen Flächen exportieren</translation>
        </message>
        <message>
            <source>the compressed file is damaged</source>
            <translation>die komprimierte Datei ist beschädigt</translation>
        </message>
        <message>
            <source>the compressed file is incomplete</source>
            <translation>die komprimierte Datei ist unvollständig</translation>
        </message>
        <message>
            <source>something else follows the compressed mesh</source>
            <translation>nach dem komprimierten Netz folgt noch etwas anderes</translation>
        </message>
        <message>
            <source>Copy or compress it again</source>
            <translation>Sie noch einmal kopieren oder komprimieren</translation>
        </message>
        <message>
            <source>the unpacked mesh would take more than half of this computer's memory</source>
            <translation>das entpackte Netz bräuchte mehr als die Hälfte des Speichers dieses Rechners</translation>
        </message>
        <message>
            <source>cannot be written</source>
            <translation>lässt sich nicht schreiben</translation>
        </message>
        <message>
            <source>cannot be written in this folder</source>
            <translation>lässt sich in diesem Ordner nicht schreiben</translation>
        </message>
        <message>
            <source>cannot be replaced</source>
            <translation>lässt sich nicht ersetzen</translation>
        </message>
        <message>
            <source>cannot be made a folder</source>
            <translation>lässt sich nicht als Ordner anlegen</translation>
        </message>
        <message>
            <source>a file is there</source>
            <translation>dort ist eine Datei</translation>
        </message>
        <message>
            <source>is not a file name</source>
            <translation>ist kein Dateiname</translation>
        </message>
        <message>
            <source>Choose a file name</source>
            <translation>Einen Dateinamen wählen</translation>
        </message>
        <message>
            <source>Choose a file name inside it</source>
            <translation>Einen Dateinamen darin wählen</translation>
        </message>
        <message>
            <source>Choose another name</source>
            <translation>Einen anderen Namen wählen</translation>
        </message>
        <message>
            <source>Choose a shorter name</source>
            <translation>Einen kürzeren Namen wählen</translation>
        </message>
        <message>
            <source>Choose another place</source>
            <translation>Einen anderen Ort wählen</translation>
        </message>
        <message>
            <source>choose another place</source>
            <translation>einen anderen Ort wählen</translation>
        </message>
        <message>
            <source>Make room on the disk, or choose another place</source>
            <translation>Platz auf dem Datenträger schaffen oder einen anderen Ort wählen</translation>
        </message>
        <message>
            <source>Make room for temporary files</source>
            <translation>Platz für temporäre Dateien schaffen</translation>
        </message>
        <message>
            <source>The file would be larger than is allowed here</source>
            <translation>Die Datei würde größer, als hier erlaubt ist</translation>
        </message>
        <message>
            <source>Choose a folder in which you may write</source>
            <translation>Einen Ordner wählen, in den Sie schreiben dürfen</translation>
        </message>
        <message>
            <source>This disk can only be read</source>
            <translation>Dieser Datenträger lässt sich nur lesen</translation>
        </message>
        <message>
            <source>Create the folder first, or choose another one</source>
            <translation>Erst den Ordner anlegen oder einen anderen wählen</translation>
        </message>
        <message>
            <source>the file is write-protected</source>
            <translation>die Datei ist schreibgeschützt</translation>
        </message>
        <message>
            <source>Save under another name</source>
            <translation>Unter einem anderen Namen speichern</translation>
        </message>
        <message>
            <source>the coordinates are too large for binary STL</source>
            <translation>die Koordinaten sind zu groß für binäres STL</translation>
        </message>
        <message>
            <source>the coordinates are too large for glTF</source>
            <translation>die Koordinaten sind zu groß für glTF</translation>
        </message>
        <message>
            <source>Save as PLY, or scale the mesh down</source>
            <translation>Als PLY speichern oder das Netz verkleinern</translation>
        </message>
        <message>
            <source>the mesh takes more than the 4 GB of a GLB file</source>
            <translation>das Netz braucht mehr als die 4 GB einer GLB-Datei</translation>
        </message>
        <message>
            <source>Save as PLY</source>
            <translation>Als PLY speichern</translation>
        </message>
        <message>
            <source>the name has no extension</source>
            <translation>der Name hat keine Endung</translation>
        </message>
        <message>
            <source>unknown format %1</source>
            <translation>unbekanntes Format %1</translation>
        </message>
        <message>
            <source>Choose a name that ends in .ply, .stl, .obj, .off, .glb, .gltf or .3mf, compressed .ply.gz and so on</source>
            <translation>Einen Namen wählen, der auf .ply, .stl, .obj, .off, .glb, .gltf oder .3mf endet, komprimiert .ply.gz und so fort</translation>
        </message>
        <message>
            <source>another file of this name is there already, which the scan's %1 would replace</source>
            <translation>eine andere Datei dieses Namens ist schon da; %1 des Scans würde sie ersetzen</translation>
        </message>
        <message>
            <source>Choose another folder for the output</source>
            <translation>Einen anderen Ordner für die Ausgabe wählen</translation>
        </message>
        <message>
            <source>The file %1 is outside the scan's folder and was not copied</source>
            <translation>Die Datei %1 liegt außerhalb des Ordners des Scans und wurde nicht kopiert</translation>
        </message>
        <message>
            <source>The file %1 cannot be read and was not copied</source>
            <translation>Die Datei %1 lässt sich nicht lesen und wurde nicht kopiert</translation>
        </message>
        <message>
            <source>The picture %1 is not there, and not in the output</source>
            <translation>Das Bild %1 fehlt, auch in der Ausgabe</translation>
        </message>
        <message>
            <source>The %1 of the scan cannot be used</source>
            <translation>%1 des Scans lässt sich nicht verwenden</translation>
        </message>
        <message>
            <source>The scan's material file cannot be used</source>
            <translation>Die Materialdatei des Scans lässt sich nicht verwenden</translation>
        </message>
        <message>
            <source>A picture of the scan's texture cannot be used</source>
            <translation>Ein Bild der Textur des Scans lässt sich nicht verwenden</translation>
        </message>
        <message>
            <source>%1 new triangles have no texture</source>
            <translation>%1 neue Dreiecke haben keine Textur</translation>
        </message>
        <message>
            <source>their patch cannot be laid out in a plane, or the picture would be too large</source>
            <translation>ihr Flicken lässt sich nicht in die Ebene legen, oder das Bild würde zu groß</translation>
        </message>
        <message>
            <source>the archive cannot be written</source>
            <translation>das Archiv lässt sich nicht schreiben</translation>
        </message>
        <message>
            <source>libzip failed</source>
            <translation>libzip hat versagt</translation>
        </message>
        <message>
            <source>the picture is damaged</source>
            <translation>das Bild ist beschädigt</translation>
        </message>
        <message>
            <source>the picture cannot be read</source>
            <translation>das Bild lässt sich nicht lesen</translation>
        </message>
        <message>
            <source>the picture cannot be written</source>
            <translation>das Bild lässt sich nicht schreiben</translation>
        </message>
        <message>
            <source>this is neither PNG nor JPEG</source>
            <translation>dies ist weder PNG noch JPEG</translation>
        </message>
        <message>
            <source>a picture of %1 by %2 pixels</source>
            <translation>ein Bild von %1 mal %2 Pixeln</translation>
        </message>
        <message>
            <source>it is larger than 16384 pixels a side</source>
            <translation>es hat mehr als 16384 Pixel je Seite</translation>
        </message>
        <message>
            <source>Save the picture again as PNG or JPEG</source>
            <translation>Das Bild noch einmal als PNG oder JPEG speichern</translation>
        </message>
        <message>
            <source>picture %1</source>
            <translation>Bild %1</translation>
        </message>
        <message>
            <source>this machine could not draw a picture of %1 pixels</source>
            <translation>dieser Rechner konnte kein Bild von %1 Pixeln zeichnen</translation>
        </message>
        <message>
            <source>Try a smaller size</source>
            <translation>Eine kleinere Größe versuchen</translation>
        </message>
        <message>
            <source>No such file or directory</source>
            <translation>Datei oder Ordner nicht gefunden</translation>
        </message>
        <message>
            <source>Permission denied</source>
            <translation>keine Berechtigung</translation>
        </message>
        <message>
            <source>No space left on device</source>
            <translation>kein Platz mehr auf dem Datenträger</translation>
        </message>
        <message>
            <source>Read-only file system</source>
            <translation>schreibgeschützter Datenträger</translation>
        </message>
        <message>
            <source>Input/output error</source>
            <translation>Ein-/Ausgabefehler</translation>
        </message>
        <message>
            <source>File too large</source>
            <translation>Datei zu groß</translation>
        </message>
        <message>
            <source>File name too long</source>
            <translation>Dateiname zu lang</translation>
        </message>
        <message>
            <source>Not a directory</source>
            <translation>kein Ordner</translation>
        </message>
        <message>
            <source>this is not a session of Loopmend</source>
            <translation>dies ist keine Sitzung von Loopmend</translation>
        </message>
        <message>
            <source>Choose a file that Loopmend saved</source>
            <translation>Eine Datei wählen, die Loopmend gespeichert hat</translation>
        </message>
        <message>
            <source>this session is of another version of Loopmend</source>
            <translation>diese Sitzung ist von einer anderen Version von Loopmend</translation>
        </message>
        <message>
            <source>Open it with the version that saved it</source>
            <translation>Sie mit der Version öffnen, die sie gespeichert hat</translation>
        </message>
        <message>
            <source>Open the scan itself instead</source>
            <translation>Stattdessen den Scan selbst öffnen</translation>
        </message>
        <message>
            <source>the session file is damaged</source>
            <translation>die Sitzungsdatei ist beschädigt</translation>
        </message>
        <message>
            <source>a patch belongs to a hole that does not exist</source>
            <translation>ein Flicken gehört zu einem Loch, das es nicht gibt</translation>
        </message>
        <message>
            <source>a patch names a vertex that its scan does not have</source>
            <translation>ein Flicken nennt eine Ecke, die sein Scan nicht hat</translation>
        </message>
        <message>
            <source>a patch belongs to no scan</source>
            <translation>ein Flicken gehört zu keinem Scan</translation>
        </message>
        <message>
            <source>the loops of a patch are not complete</source>
            <translation>die Ränder eines Flickens sind nicht vollständig</translation>
        </message>
        <message>
            <source>a unit of length is not known</source>
            <translation>eine Längeneinheit ist nicht bekannt</translation>
        </message>
        <message>
            <source>there is more in the file than there should be</source>
            <translation>in der Datei ist mehr, als darin sein sollte</translation>
        </message>
        <message>
            <source>the number of scans is out of range</source>
            <translation>die Zahl der Scans liegt außerhalb des Erlaubten</translation>
        </message>
        <message>
            <source>the scan in the session cannot be unpacked</source>
            <translation>der Scan in der Sitzung lässt sich nicht entpacken</translation>
        </message>
        <message>
            <source>this file has changed since the session was saved</source>
            <translation>diese Datei hat sich seit dem Speichern der Sitzung geändert</translation>
        </message>
        <message>
            <source>Put the old file back to restore the session, or open the new one by itself</source>
            <translation>Die alte Datei zurücklegen, um die Sitzung zu öffnen, oder die neue für sich öffnen</translation>
        </message>
        <message>
            <source>%1 has its numbers in files beside it</source>
            <translation>%1 hat seine Zahlen in Dateien daneben</translation>
        </message>
        <message>
            <source>export it as GLB, or save the session without scans</source>
            <translation>es als GLB exportieren oder die Sitzung ohne Scans speichern</translation>
        </message>
        <message>
            <source>%1 is larger than 1 GB</source>
            <translation>%1 ist größer als 1 GB</translation>
        </message>
        <message>
            <source>save the session without scans, and keep the file beside it</source>
            <translation>die Sitzung ohne Scans speichern und die Datei daneben aufheben</translation>
        </message>
        <message>
            <source>line %1</source>
            <translation>Zeile %1</translation>
        </message>
        <message>
            <source>line %1 of %2</source>
            <translation>Zeile %1 von %2</translation>
        </message>
        <message>
            <source>byte %1</source>
            <translation>Byte %1</translation>
        </message>
        <message>
            <source>byte %1 of the text</source>
            <translation>Byte %1 des Textes</translation>
        </message>
        <message>
            <source>%1 points</source>
            <translation>%1 Punkte</translation>
        </message>
        <message>
            <source>vertex %1</source>
            <translation>Ecke %1</translation>
        </message>
        <message>
            <source>vertex %1 of %2</source>
            <translation>Ecke %1 von %2</translation>
        </message>
        <message>
            <source>face %1</source>
            <translation>Fläche %1</translation>
        </message>
        <message>
            <source>face %1 of %2</source>
            <translation>Fläche %1 von %2</translation>
        </message>
        <message>
            <source>facet %1</source>
            <translation>Facette %1</translation>
        </message>
        <message>
            <source>node %1</source>
            <translation>Knoten %1</translation>
        </message>
        <message>
            <source>mesh %1</source>
            <translation>Netz %1</translation>
        </message>
        <message>
            <source>mesh %1, primitive %2</source>
            <translation>Netz %1, Teil %2</translation>
        </message>
        <message>
            <source>buffer %1</source>
            <translation>Puffer %1</translation>
        </message>
        <message>
            <source>buffer view %1</source>
            <translation>Pufferansicht %1</translation>
        </message>
        <message>
            <source>accessor %1</source>
            <translation>Zugriff %1</translation>
        </message>
        <message>
            <source>accessor %1, sparse</source>
            <translation>Zugriff %1, dünn besetzt</translation>
        </message>
        <message>
            <source>material %1</source>
            <translation>Material %1</translation>
        </message>
        <message>
            <source>object %1 of %2</source>
            <translation>Objekt %1 von %2</translation>
        </message>
        <message>
            <source>entry %1</source>
            <translation>Eintrag %1</translation>
        </message>
        <message>
            <source>scene %1</source>
            <translation>Szene %1</translation>
        </message>
        <message>
            <source>It is incomplete</source>
            <translation>Sie ist unvollständig</translation>
        </message>
        <message>
            <source>The file is incomplete</source>
            <translation>Die Datei ist unvollständig</translation>
        </message>
        <message>
            <source>It is incomplete or damaged</source>
            <translation>Sie ist unvollständig oder beschädigt</translation>
        </message>
        <message>
            <source>The file is damaged or incomplete</source>
            <translation>Die Datei ist beschädigt oder unvollständig</translation>
        </message>
        <message>
            <source>export or copy it again</source>
            <translation>sie noch einmal exportieren oder kopieren</translation>
        </message>
        <message>
            <source>Export it again</source>
            <translation>Sie noch einmal exportieren</translation>
        </message>
        <message>
            <source>Copy or download it again</source>
            <translation>Sie noch einmal kopieren oder herunterladen</translation>
        </message>
        <message>
            <source>the file ends too early</source>
            <translation>die Datei endet zu früh</translation>
        </message>
        <message>
            <source>the file ends too early, in %1</source>
            <translation>die Datei endet zu früh, in %1</translation>
        </message>
        <message>
            <source>the header</source>
            <translation>dem Kopf</translation>
        </message>
        <message>
            <source>there is no "end_header"</source>
            <translation>„end_header“ fehlt</translation>
        </message>
        <message>
            <source>the header of a binary STL file</source>
            <translation>dem Kopf einer binären STL-Datei</translation>
        </message>
        <message>
            <source>the header of the GLB file</source>
            <translation>dem Kopf der GLB-Datei</translation>
        </message>
        <message>
            <source>a GLB file of %1 bytes</source>
            <translation>einer GLB-Datei von %1 Bytes</translation>
        </message>
        <message>
            <source>announces %1 %2, more than a file of %3 bytes can hold</source>
            <translation>kündigt %1 %2 an, mehr als eine Datei von %3 Bytes fassen kann</translation>
        </message>
        <message>
            <source>vertices</source>
            <translation>Ecken</translation>
        </message>
        <message>
            <source>faces</source>
            <translation>Flächen</translation>
        </message>
        <message>
            <source>elements</source>
            <translation>Elemente</translation>
        </message>
        <message>
            <source>rows of %1</source>
            <translation>Zeilen von %1</translation>
        </message>
        <message>
            <source>announces %1 triangles, which take %2 bytes, but the file has %3</source>
            <translation>kündigt %1 Dreiecke an, die %2 Bytes brauchen, aber die Datei hat %3</translation>
        </message>
        <message>
            <source>announces %1 triangles, but %2 more bytes follow them</source>
            <translation>kündigt %1 Dreiecke an, aber nach ihnen folgen %2 weitere Bytes</translation>
        </message>
        <message>
            <source>The count and the data do not belong together</source>
            <translation>Anzahl und Daten gehören nicht zusammen</translation>
        </message>
        <message>
            <source>there is more data than the header announces</source>
            <translation>es gibt mehr Daten, als der Kopf ankündigt</translation>
        </message>
        <message>
            <source>The header and the data do not belong together</source>
            <translation>Kopf und Daten gehören nicht zusammen</translation>
        </message>
        <message>
            <source>export the mesh again</source>
            <translation>das Netz noch einmal exportieren</translation>
        </message>
        <message>
            <source>more than 715827882 triangles</source>
            <translation>mehr als 715827882 Dreiecke</translation>
        </message>
        <message>
            <source>more than 2147483647 vertices</source>
            <translation>mehr als 2147483647 Ecken</translation>
        </message>
        <message>
            <source>vertex %1 has a coordinate that is not a finite number</source>
            <translation>Ecke %1 hat eine Koordinate, die keine endliche Zahl ist</translation>
        </message>
        <message>
            <source>Remove or repair that vertex in the program the file comes from</source>
            <translation>Diese Ecke in dem Programm, von dem die Datei kommt, entfernen oder berichtigen</translation>
        </message>
        <message>
            <source>face %1 names vertex %2, but there are %3, from 0 on</source>
            <translation>Fläche %1 nennt Ecke %2, aber es gibt %3, von 0 an</translation>
        </message>
        <message>
            <source>face %1 names vertex %2, but there are %3 before it</source>
            <translation>Fläche %1 nennt Ecke %2, aber vor ihr gibt es %3</translation>
        </message>
        <message>
            <source>face %1 names vertex %2, but OBJ counts from 1</source>
            <translation>Fläche %1 nennt Ecke %2, aber OBJ zählt ab 1</translation>
        </message>
        <message>
            <source>vertex %1 does not have 3 coordinates (or 6 with a colour)</source>
            <translation>Ecke %1 hat nicht 3 Koordinaten (oder 6 mit Farbe)</translation>
        </message>
        <message>
            <source>vertex %1 has a wrong number of values</source>
            <translation>Ecke %1 hat eine falsche Zahl von Werten</translation>
        </message>
        <message>
            <source>%1 is missing</source>
            <translation>%1 fehlt</translation>
        </message>
        <message>
            <source>%1 stands where %2 should be</source>
            <translation>%1 steht, wo %2 stehen sollte</translation>
        </message>
        <message>
            <source>a coordinate</source>
            <translation>eine Koordinate</translation>
        </message>
        <message>
            <source>a vertex index</source>
            <translation>eine Eckennummer</translation>
        </message>
        <message>
            <source>a count of elements</source>
            <translation>eine Anzahl von Elementen</translation>
        </message>
        <message>
            <source>the number of vertices</source>
            <translation>die Zahl der Ecken</translation>
        </message>
        <message>
            <source>the number of faces</source>
            <translation>die Zahl der Flächen</translation>
        </message>
        <message>
            <source>a number of a transform</source>
            <translation>eine Zahl einer Abbildung</translation>
        </message>
        <message>
            <source>"facet" or "endsolid"</source>
            <translation>„facet“ oder „endsolid“</translation>
        </message>
        <message>
            <source>something else stands where a number should be</source>
            <translation>etwas anderes steht, wo eine Zahl stehen sollte</translation>
        </message>
        <message>
            <source>Numbers are written with a point, not a comma</source>
            <translation>Zahlen werden mit Punkt geschrieben, nicht mit Komma</translation>
        </message>
        <message>
            <source>Correct that place, or export the mesh again</source>
            <translation>Diese Stelle berichtigen oder das Netz noch einmal exportieren</translation>
        </message>
        <message>
            <source>Correct that line, or export the mesh again</source>
            <translation>Diese Zeile berichtigen oder das Netz noch einmal exportieren</translation>
        </message>
        <message>
            <source>%1 is more than this line should hold</source>
            <translation>%1 ist mehr, als in dieser Zeile stehen sollte</translation>
        </message>
        <message>
            <source>%1 is not a statement of an OBJ file</source>
            <translation>%1 ist keine Anweisung einer OBJ-Datei</translation>
        </message>
        <message>
            <source>%1 is not a word of a PLY header</source>
            <translation>%1 ist kein Wort eines PLY-Kopfs</translation>
        </message>
        <message>
            <source>unknown PLY format %1</source>
            <translation>unbekanntes PLY-Format %1</translation>
        </message>
        <message>
            <source>unknown PLY version %1</source>
            <translation>unbekannte PLY-Version %1</translation>
        </message>
        <message>
            <source>unknown PLY type %1</source>
            <translation>unbekannter PLY-Typ %1</translation>
        </message>
        <message>
            <source>a second format line</source>
            <translation>eine zweite Formatzeile</translation>
        </message>
        <message>
            <source>a second element %1</source>
            <translation>ein zweites Element %1</translation>
        </message>
        <message>
            <source>a second property %1</source>
            <translation>eine zweite Eigenschaft %1</translation>
        </message>
        <message>
            <source>a property before any element</source>
            <translation>eine Eigenschaft vor jedem Element</translation>
        </message>
        <message>
            <source>a property without a name</source>
            <translation>eine Eigenschaft ohne Namen</translation>
        </message>
        <message>
            <source>a list counted by a fraction</source>
            <translation>eine Liste, die mit einem Bruch gezählt wird</translation>
        </message>
        <message>
            <source>the header has no format line</source>
            <translation>der Kopf hat keine Formatzeile</translation>
        </message>
        <message>
            <source>the header announces no element "vertex"</source>
            <translation>der Kopf kündigt kein Element „vertex“ an</translation>
        </message>
        <message>
            <source>This PLY file holds something else than a mesh</source>
            <translation>Diese PLY-Datei enthält etwas anderes als ein Netz</translation>
        </message>
        <message>
            <source>the vertices have no coordinates x, y and z</source>
            <translation>die Ecken haben keine Koordinaten x, y und z</translation>
        </message>
        <message>
            <source>Export the mesh with vertex positions</source>
            <translation>Das Netz mit den Orten der Ecken exportieren</translation>
        </message>
        <message>
            <source>the faces' vertex indices are not a list of whole numbers</source>
            <translation>die Eckennummern der Flächen sind keine Liste ganzer Zahlen</translation>
        </message>
        <message>
            <source>the faces have no list vertex_indices</source>
            <translation>die Flächen haben keine Liste vertex_indices</translation>
        </message>
        <message>
            <source>Export the mesh with polygon faces</source>
            <translation>Das Netz mit Vielecken als Flächen exportieren</translation>
        </message>
        <message>
            <source>binary OFF is not supported</source>
            <translation>binäres OFF wird nicht unterstützt</translation>
        </message>
        <message>
            <source>Save it as text OFF, or as PLY</source>
            <translation>Es als OFF in Textform oder als PLY speichern</translation>
        </message>
        <message>
            <source>vertices with other than 3 coordinates are not supported</source>
            <translation>Ecken mit anderen als 3 Koordinaten werden nicht unterstützt</translation>
        </message>
        <message>
            <source>Export the mesh as plain OFF</source>
            <translation>Das Netz als einfaches OFF exportieren</translation>
        </message>
        <message>
            <source>version %1 of glTF</source>
            <translation>Version %1 von glTF</translation>
        </message>
        <message>
            <source>version %1 of GLB</source>
            <translation>Version %1 von GLB</translation>
        </message>
        <message>
            <source>Loopmend reads glTF 2</source>
            <translation>Loopmend liest glTF 2</translation>
        </message>
        <message>
            <source>Loopmend reads version 2</source>
            <translation>Loopmend liest Version 2</translation>
        </message>
        <message>
            <source>export it again as such</source>
            <translation>als solches noch einmal exportieren</translation>
        </message>
        <message>
            <source>the JSON text is nested more than %1 deep</source>
            <translation>der JSON-Text ist mehr als %1 Ebenen tief</translation>
        </message>
        <message>
            <source>the JSON text of this glTF file is damaged</source>
            <translation>der JSON-Text dieser glTF-Datei ist beschädigt</translation>
        </message>
        <message>
            <source>the JSON text of this glTF file is no object</source>
            <translation>der JSON-Text dieser glTF-Datei ist kein Objekt</translation>
        </message>
        <message>
            <source>a number in the JSON text of this glTF file is too large</source>
            <translation>eine Zahl im JSON-Text dieser glTF-Datei ist zu groß</translation>
        </message>
        <message>
            <source>"asset" is missing, which every glTF file has</source>
            <translation>„asset“ fehlt, das jede glTF-Datei hat</translation>
        </message>
        <message>
            <source>chunk %1 says %2 bytes, but there are %3</source>
            <translation>Abschnitt %1 nennt %2 Bytes, aber es gibt %3</translation>
        </message>
        <message>
            <source>the first chunk of the GLB file is no JSON</source>
            <translation>der erste Abschnitt der GLB-Datei ist kein JSON</translation>
        </message>
        <message>
            <source>the GLB file has no JSON chunk</source>
            <translation>die GLB-Datei hat keinen JSON-Abschnitt</translation>
        </message>
        <message>
            <source>the mesh is compressed with %1, which Loopmend does not know</source>
            <translation>das Netz ist mit %1 komprimiert, das Loopmend nicht kennt</translation>
        </message>
        <message>
            <source>needs the extension %1, which Loopmend does not know</source>
            <translation>braucht die Erweiterung %1, die Loopmend nicht kennt</translation>
        </message>
        <message>
            <source>Export it without mesh compression</source>
            <translation>Es ohne Komprimierung des Netzes exportieren</translation>
        </message>
        <message>
            <source>Export it without</source>
            <translation>Es ohne exportieren</translation>
        </message>
        <message>
            <source>Export it without encryption</source>
            <translation>Es ohne Verschlüsselung exportieren</translation>
        </message>
        <message>
            <source>If the mesh is compressed, export it without compression</source>
            <translation>Ist das Netz komprimiert, es ohne Komprimierung exportieren</translation>
        </message>
        <message>
            <source>If the mesh is compressed (Draco, meshopt), export it without compression</source>
            <translation>Ist das Netz komprimiert (Draco, meshopt), es ohne Komprimierung exportieren</translation>
        </message>
        <message>
            <source>Put the buffer beside the file, or export one .glb file</source>
            <translation>Den Puffer neben die Datei legen oder eine einzelne .glb-Datei exportieren</translation>
        </message>
        <message>
            <source>%1 is no array</source>
            <translation>%1 ist keine Liste</translation>
        </message>
        <message>
            <source>%1 is no whole number from 0 on</source>
            <translation>%1 ist keine ganze Zahl ab 0</translation>
        </message>
        <message>
            <source>names element %1 of %2, but there are %3, from 0 on</source>
            <translation>nennt Element %1 von %2, aber es gibt %3, von 0 an</translation>
        </message>
        <message>
            <source>replaces element %1, but there are %2, from 0 on</source>
            <translation>ersetzt Element %1, aber es gibt %2, von 0 an</translation>
        </message>
        <message>
            <source>element %1 of %2 is no object</source>
            <translation>Element %1 von %2 ist kein Objekt</translation>
        </message>
        <message>
            <source>the buffer %1 cannot be read</source>
            <translation>der Puffer %1 lässt sich nicht lesen</translation>
        </message>
        <message>
            <source>has neither a "uri" nor a binary chunk</source>
            <translation>hat weder „uri“ noch einen binären Abschnitt</translation>
        </message>
        <message>
            <source>announces %1 bytes, but there are %2</source>
            <translation>kündigt %1 Bytes an, aber es gibt %2</translation>
        </message>
        <message>
            <source>bytes %1 to %2 of a buffer of %3</source>
            <translation>die Bytes %1 bis %2 eines Puffers von %3</translation>
        </message>
        <message>
            <source>its elements of %1 bytes stand %2 bytes apart</source>
            <translation>seine Elemente von %1 Bytes stehen %2 Bytes auseinander</translation>
        </message>
        <message>
            <source>(at byte %1 of %2) elements</source>
            <translation>(ab Byte %1 von %2) Elemente</translation>
        </message>
        <message>
            <source>has no data</source>
            <translation>hat keine Daten</translation>
        </message>
        <message>
            <source>there are no data</source>
            <translation>es gibt keine Daten</translation>
        </message>
        <message>
            <source>is of an unknown type</source>
            <translation>ist von unbekanntem Typ</translation>
        </message>
        <message>
            <source>its indices are no unsigned numbers</source>
            <translation>seine Nummern sind keine vorzeichenlosen Zahlen</translation>
        </message>
        <message>
            <source>the data URI is not of base64</source>
            <translation>die Daten-URI ist nicht in base64</translation>
        </message>
        <message>
            <source>the data URI is damaged</source>
            <translation>die Daten-URI ist beschädigt</translation>
        </message>
        <message>
            <source>%1 names no file</source>
            <translation>%1 nennt keine Datei</translation>
        </message>
        <message>
            <source>%1 is not beside the file</source>
            <translation>%1 liegt nicht neben der Datei</translation>
        </message>
        <message>
            <source>%1 is outside the folder of the file, where nothing is read</source>
            <translation>%1 liegt außerhalb des Ordners der Datei, wo nichts gelesen wird</translation>
        </message>
        <message>
            <source>names a node that is not there, %1</source>
            <translation>nennt einen Knoten, den es nicht gibt, %1</translation>
        </message>
        <message>
            <source>the nodes go round in circles</source>
            <translation>die Knoten laufen im Kreis</translation>
        </message>
        <message>
            <source>is reached twice</source>
            <translation>ist zweimal zu erreichen</translation>
        </message>
        <message>
            <source>the nodes of glTF are a tree</source>
            <translation>die Knoten von glTF sind ein Baum</translation>
        </message>
        <message>
            <source>%1 has %2 numbers</source>
            <translation>%1 hat %2 Zahlen</translation>
        </message>
        <message>
            <source>%1 has %2 numbers each</source>
            <translation>%1 hat je %2 Zahlen</translation>
        </message>
        <message>
            <source>%1 has %2 elements for %3 positions</source>
            <translation>%1 hat %2 Elemente für %3 Orte</translation>
        </message>
        <message>
            <source>"rotation" is none</source>
            <translation>„rotation“ ist keine Drehung</translation>
        </message>
        <message>
            <source>the transforms of its nodes are too large</source>
            <translation>die Abbildungen seiner Knoten sind zu groß</translation>
        </message>
        <message>
            <source>is no object</source>
            <translation>ist kein Objekt</translation>
        </message>
        <message>
            <source>%1 is no object</source>
            <translation>%1 ist kein Objekt</translation>
        </message>
        <message>
            <source>a picture is no object</source>
            <translation>ein Bild ist kein Objekt</translation>
        </message>
        <message>
            <source>has the unknown mode %1</source>
            <translation>hat die unbekannte Art %1</translation>
        </message>
        <message>
            <source>has no POSITION</source>
            <translation>hat keine POSITION</translation>
        </message>
        <message>
            <source>%1 corners, which are not three for each triangle</source>
            <translation>%1 Ecken, was nicht drei je Dreieck sind</translation>
        </message>
        <message>
            <source>the same triangles are shown again and again, in all more than %1</source>
            <translation>dieselben Dreiecke sind wieder und wieder da, zusammen mehr als %1</translation>
        </message>
        <message>
            <source>Export it with fewer instances</source>
            <translation>Es mit weniger Kopien exportieren</translation>
        </message>
        <message>
            <source>the XML is damaged</source>
            <translation>das XML ist beschädigt</translation>
        </message>
        <message>
            <source>the XML is nested more than %1 deep</source>
            <translation>das XML ist mehr als %1 Ebenen tief</translation>
        </message>
        <message>
            <source>the XML has a document type, which 3MF forbids</source>
            <translation>das XML hat einen Dokumenttyp, was 3MF verbietet</translation>
        </message>
        <message>
            <source>an element of the XML has no end</source>
            <translation>ein Element des XML hat kein Ende</translation>
        </message>
        <message>
            <source>the part holds no model</source>
            <translation>der Teil enthält kein Modell</translation>
        </message>
        <message>
            <source>a material stands outside "basematerials"</source>
            <translation>ein Material steht außerhalb von „basematerials“</translation>
        </message>
        <message>
            <source>a colour stands outside "colorgroup"</source>
            <translation>eine Farbe steht außerhalb von „colorgroup“</translation>
        </message>
        <message>
            <source>%1 is no colour</source>
            <translation>%1 ist keine Farbe</translation>
        </message>
        <message>
            <source>%1 is no unit of 3MF</source>
            <translation>%1 ist keine Einheit von 3MF</translation>
        </message>
        <message>
            <source>there are two objects %1</source>
            <translation>es gibt zwei Objekte %1</translation>
        </message>
        <message>
            <source>a vertex, triangle or component stands outside an object</source>
            <translation>eine Ecke, ein Dreieck oder ein Bestandteil steht außerhalb eines Objekts</translation>
        </message>
        <message>
            <source>a transform has %1 numbers, not 12</source>
            <translation>eine Abbildung hat %1 Zahlen, nicht 12</translation>
        </message>
        <message>
            <source>its parts have different units, %1 and %2</source>
            <translation>seine Teile haben verschiedene Einheiten, %1 und %2</translation>
        </message>
        <message>
            <source>objects are made of one another more than %1 deep</source>
            <translation>Objekte bestehen mehr als %1 Ebenen tief aus einander</translation>
        </message>
        <message>
            <source>more than %1 objects</source>
            <translation>mehr als %1 Objekte</translation>
        </message>
        <message>
            <source>names an object that is not there</source>
            <translation>nennt ein Objekt, das es nicht gibt</translation>
        </message>
        <message>
            <source>the same triangles are there again and again, in all more than %1</source>
            <translation>dieselben Dreiecke sind wieder und wieder da, zusammen mehr als %1</translation>
        </message>
        <message>
            <source>Export it with fewer copies</source>
            <translation>Es mit weniger Kopien exportieren</translation>
        </message>
        <message>
            <source>names member %1 of property group %2, which has %3</source>
            <translation>nennt Mitglied %1 der Eigenschaftsgruppe %2, die %3 hat</translation>
        </message>
        <message>
            <source>this is a ZIP archive without a 3MF model, not a mesh file</source>
            <translation>dies ist ein ZIP-Archiv ohne 3MF-Modell, keine Netzdatei</translation>
        </message>
        <message>
            <source>Unpack it, and open what is in it</source>
            <translation>Es entpacken und öffnen, was darin ist</translation>
        </message>
        <message>
            <source>the ZIP archive is damaged or incomplete (%1)</source>
            <translation>das ZIP-Archiv ist beschädigt oder unvollständig (%1)</translation>
        </message>
        <message>
            <source>a part of the archive is missing</source>
            <translation>ein Teil des Archivs fehlt</translation>
        </message>
        <message>
            <source>an entry cannot be unpacked</source>
            <translation>ein Eintrag lässt sich nicht entpacken</translation>
        </message>
        <message>
            <source>an entry is damaged</source>
            <translation>ein Eintrag ist beschädigt</translation>
        </message>
        <message>
            <source>an entry becomes more than %1 times as large as the file when it is unpacked</source>
            <translation>ein Eintrag wird beim Entpacken mehr als %1-mal so groß wie die Datei</translation>
        </message>
        <message>
            <source>This is no mesh but a trap</source>
            <translation>Dies ist kein Netz, sondern eine Falle</translation>
        </message>
        <message>
            <source>do not open it</source>
            <translation>sie nicht öffnen</translation>
        </message>
        <message>
            <source>primitives of points and lines</source>
            <translation>Teile aus Punkten und Linien</translation>
        </message>
        <message>
            <source>primitives with morph targets</source>
            <translation>Teile mit Morph-Zielen</translation>
        </message>
        <message>
            <source>vertex attributes %1</source>
            <translation>Eckenattribute %1</translation>
        </message>
        <message>
            <source>further colours at one place</source>
            <translation>weitere Farben an einem Ort</translation>
        </message>
        <message>
            <source>further colours at one vertex</source>
            <translation>weitere Farben an einer Ecke</translation>
        </message>
        <message>
            <source>transforms of nodes, which are applied</source>
            <translation>Abbildungen von Knoten, die angewandt sind</translation>
        </message>
        <message>
            <source>transforms of objects, which are applied</source>
            <translation>Abbildungen von Objekten, die angewandt sind</translation>
        </message>
        <message>
            <source>meshes that the scene does not show</source>
            <translation>Netze, die die Szene nicht zeigt</translation>
        </message>
        <message>
            <source>pictures of materials</source>
            <translation>Bilder von Materialien</translation>
        </message>
        <message>
            <source>pictures of materials at further texture coordinates</source>
            <translation>Bilder von Materialien an weiteren Texturkoordinaten</translation>
        </message>
        <message>
            <source>keyword in lower case</source>
            <translation>Schlüsselwort in Kleinbuchstaben</translation>
        </message>
        <message>
            <source>strip properties %1</source>
            <translation>Eigenschaften von Streifen %1</translation>
        </message>
        <message>
            <source>face properties %1</source>
            <translation>Eigenschaften von Flächen %1</translation>
        </message>
        <message>
            <source>elements %1</source>
            <translation>Elemente %1</translation>
        </message>
        <message>
            <source>textures of 3MF</source>
            <translation>Texturen von 3MF</translation>
        </message>
        <message>
            <source>mixed materials</source>
            <translation>gemischte Materialien</translation>
        </message>
        <message>
            <source>beam lattices</source>
            <translation>Stabgitter</translation>
        </message>
        <message>
            <source>metadata</source>
            <translation>Metadaten</translation>
        </message>
        <message>
            <source>unit (%1)</source>
            <translation>Einheit (%1)</translation>
        </message>
        <message>
            <source>vertices without a place that no face uses, now at the origin</source>
            <translation>Ecken ohne Ort, die keine Fläche nutzt, jetzt im Ursprung</translation>
        </message>
        <message>
            <source>remarks between the facets</source>
            <translation>Bemerkungen zwischen den Facetten</translation>
        </message>
        <message>
            <source>words after "endloop" or "endfacet"</source>
            <translation>Wörter nach „endloop“ oder „endfacet“</translation>
        </message>
        <message>
            <source>count of triangles that is 0</source>
            <translation>Anzahl der Dreiecke, die 0 ist</translation>
        </message>
        <message>
            <source>taken from the file's size</source>
            <translation>aus der Größe der Datei bestimmt</translation>
        </message>
        <message>
            <source>bytes after the last triangle, left out</source>
            <translation>Bytes nach dem letzten Dreieck, weggelassen</translation>
        </message>
        <message>
            <source>no build</source>
            <translation>kein Bauauftrag</translation>
        </message>
        <message>
            <source>every object is taken</source>
            <translation>jedes Objekt wird genommen</translation>
        </message>
        <message>
            <source>faces with properties of other kinds</source>
            <translation>Flächen mit Eigenschaften anderer Art</translation>
        </message>
        <message>
            <source>further parts of the archive</source>
            <translation>weitere Teile des Archivs</translation>
        </message>
        <message>
            <source>comments that begin with //</source>
            <translation>Kommentare, die mit // beginnen</translation>
        </message>
        <message>
            <source>unknown statements</source>
            <translation>unbekannte Anweisungen</translation>
        </message>
        <message>
            <source>texture coordinates that are no numbers</source>
            <translation>Texturkoordinaten, die keine Zahlen sind</translation>
        </message>
        <message>
            <source>normals that are no numbers</source>
            <translation>Normalen, die keine Zahlen sind</translation>
        </message>
        <message>
            <source>numbers of texture coordinates that are not there</source>
            <translation>Nummern von Texturkoordinaten, die es nicht gibt</translation>
        </message>
        <message>
            <source>numbers of normals that are not there</source>
            <translation>Nummern von Normalen, die es nicht gibt</translation>
        </message>
        <message>
            <source>points in parameter space</source>
            <translation>Punkte im Parameterraum</translation>
        </message>
        <message>
            <source>free-form curves and surfaces</source>
            <translation>Freiformkurven und -flächen</translation>
        </message>
        <message>
            <source>faces of fewer than three corners, left out</source>
            <translation>Flächen mit weniger als drei Ecken, weggelassen</translation>
        </message>
        <message>
            <source>a crack</source>
            <translation>ein Riss</translation>
        </message>
        <message>
            <source>a face at the same place covers it already</source>
            <translation>eine Fläche am selben Ort deckt ihn schon ab</translation>
        </message>
        <message>
            <source>its edges lie exactly on other boundary edges, so that nothing is missing between them</source>
            <translation>seine Kanten liegen genau auf anderen Randkanten, sodass dazwischen nichts fehlt</translation>
        </message>
        <message>
            <source>Stitch in the tab Patch joins them</source>
            <translation>„Vernähen“ im Reiter Flicken verbindet sie</translation>
        </message>
        <message>
            <source>no hole</source>
            <translation>kein Loch</translation>
        </message>
        <message>
            <source>it runs where the surface had to be cut, along an edge with more than two faces or because the surface is one-sided</source>
            <translation>er läuft, wo die Fläche geschnitten werden musste, an einer Kante mit mehr als zwei Flächen oder weil die Fläche einseitig ist</translation>
        </message>
        <message>
            <source>all vertices of the loop are in one place</source>
            <translation>alle Ecken des Randes liegen an einem Ort</translation>
        </message>
        <message>
            <source>the loop is the boundary of a single triangle</source>
            <translation>dies ist der Rand eines einzelnen Dreiecks</translation>
        </message>
        <message>
            <source>the patch would need about %1 vertices</source>
            <translation>der Flicken bräuchte etwa %1 Ecken</translation>
        </message>
        <message>
            <source>the patch would need more than %1 vertices</source>
            <translation>der Flicken bräuchte mehr als %1 Ecken</translation>
        </message>
        <message>
            <source>%1 million</source>
            <translation>%1 Millionen</translation>
        </message>
        <message>
            <source>far too many</source>
            <translation>viel zu viele</translation>
        </message>
        <message>
            <source>a lower Density needs fewer</source>
            <translation>eine kleinere Dichte braucht weniger</translation>
        </message>
        <message>
            <source>%1 edges of this loop have no length</source>
            <translation>%1 Kanten dieses Randes haben keine Länge</translation>
        </message>
        <message>
            <source>Repair… in the tab Patch can join their vertices</source>
            <translation>„Reparieren…“ im Reiter Flicken kann ihre Ecken verbinden</translation>
        </message>
        <message>
            <source>no valid triangulation of this loop was found</source>
            <translation>für diesen Rand fand sich kein gültiges Dreiecksnetz</translation>
        </message>
        <message>
            <source>No valid triangulation of this loop was found</source>
            <translation>Für diesen Rand fand sich kein gültiges Dreiecksnetz</translation>
        </message>
        <message>
            <source>the initial patch has %1 left</source>
            <translation>im ersten Flicken bleiben %1</translation>
        </message>
        <message>
            <source>the bridge has %1 left</source>
            <translation>in der Brücke bleiben %1</translation>
        </message>
        <message>
            <source>%1 folded edges</source>
            <translation>%1 gefaltete Kanten</translation>
        </message>
        <message>
            <source>%1 self-intersections</source>
            <translation>%1 Selbstschnitte</translation>
        </message>
        <message>
            <source>%1 folded edges and %2 self-intersections</source>
            <translation>%1 gefaltete Kanten und %2 Selbstschnitte</translation>
        </message>
        <message>
            <source>a blend needs at least two loops, not %1</source>
            <translation>zum Verbinden braucht es mindestens zwei Ränder, nicht %1</translation>
        </message>
        <message>
            <source>loop %1 is no hole but a crack</source>
            <translation>Rand %1 ist kein Loch, sondern ein Riss</translation>
        </message>
        <message>
            <source>loop %1 is no hole but a cut</source>
            <translation>Rand %1 ist kein Loch, sondern ein Schnitt</translation>
        </message>
        <message>
            <source>it cannot be joined to others</source>
            <translation>er lässt sich nicht mit anderen verbinden</translation>
        </message>
        <message>
            <source>all vertices of loop %1 are in one place</source>
            <translation>alle Ecken von Rand %1 liegen an einem Ort</translation>
        </message>
        <message>
            <source>loop %1 is named twice</source>
            <translation>Rand %1 ist zweimal genannt</translation>
        </message>
        <message>
            <source>loop %1 touches another loop, or itself, at a vertex</source>
            <translation>Rand %1 berührt einen anderen oder sich selbst an einer Ecke</translation>
        </message>
        <message>
            <source>every first surface between these loops folds or cuts itself all over</source>
            <translation>jede erste Fläche zwischen diesen Rändern faltet oder schneidet sich überall</translation>
        </message>
        <message>
            <source>a lower Density may help</source>
            <translation>eine kleinere Dichte kann helfen</translation>
        </message>
        <message>
            <source>no surface that joins these loops was found</source>
            <translation>es fand sich keine Fläche, die diese Ränder verbindet</translation>
        </message>
        <message>
            <source>they do not face a common middle, nor each other</source>
            <translation>sie weisen weder auf eine gemeinsame Mitte noch aufeinander</translation>
        </message>
        <message>
            <source>two of the loops bound one piece of surface, but its inside faces the gap at one of them and its outside at the other</source>
            <translation>zwei der Ränder gehören zu einem Flächenstück, aber am einen weist seine Innenseite zur Lücke, am anderen seine Außenseite</translation>
        </message>
        <message>
            <source>no two-sided surface joins them</source>
            <translation>keine zweiseitige Fläche verbindet sie</translation>
        </message>
        <message>
            <source>a loop was lost when its surface was turned round</source>
            <translation>ein Rand ging verloren, als seine Fläche gewendet wurde</translation>
        </message>
        <message>
            <source>vertex %1 lies on no boundary loop</source>
            <translation>Ecke %1 liegt auf keinem Rand</translation>
        </message>
        <message>
            <source>the boundary edges that begin at vertices %1 and %2 have a vertex in common</source>
            <translation>die Randkanten, die an den Ecken %1 und %2 beginnen, haben eine Ecke gemeinsam</translation>
        </message>
        <message>
            <source>a bridge needs two that lie apart</source>
            <translation>eine Brücke braucht zwei, die getrennt liegen</translation>
        </message>
        <message>
            <source>left open</source>
            <translation>bleibt offen</translation>
        </message>
        <message>
            <source>left as it is</source>
            <translation>bleibt, wie es ist</translation>
        </message>
        <message>
            <source>not finished when stopped</source>
            <translation>beim Anhalten nicht fertig</translation>
        </message>
        <message>
            <source>cancelled</source>
            <translation>abgebrochen</translation>
        </message>
        <message>
            <source>not enough memory for this hole</source>
            <translation>zu wenig Speicher für dieses Loch</translation>
        </message>
        <message>
            <source>a smaller Density needs less</source>
            <translation>eine kleinere Dichte braucht weniger</translation>
        </message>
        <message>
            <source>a smaller Density needs less memory</source>
            <translation>eine kleinere Dichte braucht weniger Speicher</translation>
        </message>
        <message>
            <source>its edges are too short for its size</source>
            <translation>seine Kanten sind zu kurz für seine Größe</translation>
        </message>
        <message>
            <source>about %1 new vertices would take %2 MB of memory, and %3 MB are allowed</source>
            <translation>etwa %1 neue Ecken bräuchten %2 MB Speicher, erlaubt sind %3 MB</translation>
        </message>
        <message>
            <source>the memory for patches must be above 0 MB</source>
            <translation>der Speicher für Flicken muss über 0 MB liegen</translation>
        </message>
        <message>
            <source>an island</source>
            <translation>eine Insel</translation>
        </message>
        <message>
            <source>joined to hole %1</source>
            <translation>mit Loch %1 verbunden</translation>
        </message>
        <message>
            <source>the piece lies within hole %1, whose patch covers it</source>
            <translation>das Stück liegt in Loch %1, dessen Flicken es bedeckt</translation>
        </message>
        <message>
            <source>the piece of surface within it was not joined</source>
            <translation>das Flächenstück darin wurde nicht angeschlossen</translation>
        </message>
        <message>
            <source>no bridge was found</source>
            <translation>es fand sich keine Brücke</translation>
        </message>
        <message>
            <source>every patch that was found would cut the surface or itself, in %1 places</source>
            <translation>jeder gefundene Flicken würde die Fläche oder sich selbst schneiden, an %1 Stellen</translation>
        </message>
        <message>
            <source>the loops cannot be joined as they lie</source>
            <translation>so, wie sie liegen, lassen sich die Ränder nicht verbinden</translation>
        </message>
        <message>
            <source>%1 boundary edge intersects the surface, so that no valid patch exists</source>
            <translation>%1 Randkante schneidet die Fläche, sodass es keinen gültigen Flicken gibt</translation>
        </message>
        <message>
            <source>%1 boundary edges intersect the surface, so that no valid patch exists</source>
            <translation>%1 Randkanten schneiden die Fläche, sodass es keinen gültigen Flicken gibt</translation>
        </message>
        <message>
            <source>its patch would cut that of loop %1</source>
            <translation>sein Flicken würde den von Rand %1 schneiden</translation>
        </message>
        <message>
            <source>Blend in the tab Tools joins the two by one surface</source>
            <translation>„Verbinden“ im Reiter Werkzeuge verbindet beide durch eine Fläche</translation>
        </message>
        <message>
            <source>no hole could be filled</source>
            <translation>kein Loch ließ sich füllen</translation>
        </message>
        <message>
            <source>the loops were not joined</source>
            <translation>die Ränder wurden nicht verbunden</translation>
        </message>
        <message>
            <source>%1 faces were turned round</source>
            <translation>%1 Flächen wurden gewendet</translation>
        </message>
        <message>
            <source>their inside faced the gap</source>
            <translation>ihre Innenseite wies zur Lücke</translation>
        </message>
        <message>
            <source>between 0 and 100 rings of a boundary can be trimmed, not %1</source>
            <translation>zwischen 0 und 100 Ringe eines Randes lassen sich beschneiden, nicht %1</translation>
        </message>
        <message>
            <source>trimming the boundary would leave no triangle</source>
            <translation>nach dem Beschneiden des Randes bliebe kein Dreieck</translation>
        </message>
        <message>
            <source>the tolerance of stitching must lie between 0 and 0.4, not %1</source>
            <translation>die Toleranz beim Vernähen muss zwischen 0 und 0,4 liegen, nicht bei %1</translation>
        </message>
        <message>
            <source>the scan around the hole does not tell shape from relief</source>
            <translation>der Scan um das Loch trennt Form und Relief nicht</translation>
        </message>
        <message>
            <source>the scan around the hole is noisy</source>
            <translation>der Scan um das Loch ist verrauscht</translation>
        </message>
        <message>
            <source>the scan around the hole has relief</source>
            <translation>der Scan um das Loch hat Relief</translation>
        </message>
        <message>
            <source>the flow runs on the smooth surface under it</source>
            <translation>der Fluss läuft auf der glatten Fläche darunter</translation>
        </message>
        <message>
            <source>%1, so that its curvature counts little</source>
            <translation>%1, sodass seine Krümmung wenig zählt</translation>
        </message>
        <message>
            <source>the Boundary "Exact" runs the flow itself</source>
            <translation>mit dem Rand „Exakt“ läuft der Fluss selbst</translation>
        </message>
        <message>
            <source>robust fairing in place of the flow</source>
            <translation>robuste Glättung statt des Flusses</translation>
        </message>
        <message>
            <source>linear fairing in place of the flow</source>
            <translation>lineare Glättung statt des Flusses</translation>
        </message>
        <message>
            <source>the flow on the smooth surface under the scan</source>
            <translation>der Fluss auf der glatten Fläche unter dem Scan</translation>
        </message>
        <message>
            <source>the flow with bending energy mixed in</source>
            <translation>der Fluss mit beigemischter Biegeenergie</translation>
        </message>
        <message>
            <source>the initial patch was kept</source>
            <translation>der erste Flicken wurde behalten</translation>
        </message>
        <message>
            <source>the flow could not start</source>
            <translation>der Fluss konnte nicht beginnen</translation>
        </message>
        <message>
            <source>the flow itself did not converge</source>
            <translation>der Fluss selbst ist nicht konvergiert</translation>
        </message>
        <message>
            <source>with bending energy mixed in it did</source>
            <translation>mit beigemischter Biegeenergie schon</translation>
        </message>
        <message>
            <source>too small to hold a free vertex</source>
            <translation>zu klein für eine freie Ecke</translation>
        </message>
        <message>
            <source>closed by triangles between its own vertices</source>
            <translation>mit Dreiecken zwischen den eigenen Ecken geschlossen</translation>
        </message>
        <message>
            <source>one boundary vertex is an outlier</source>
            <translation>eine Randecke ist ein Ausreißer</translation>
        </message>
        <message>
            <source>%1 boundary vertices are outliers</source>
            <translation>%1 Randecken sind Ausreißer</translation>
        </message>
        <message>
            <source>the patch meets it, but does not take its curvature from it</source>
            <translation>der Flicken trifft sie, nimmt seine Krümmung aber nicht von ihr</translation>
        </message>
        <message>
            <source>the patch meets them, but does not take its curvature from them</source>
            <translation>der Flicken trifft sie, nimmt seine Krümmung aber nicht von ihnen</translation>
        </message>
        <message>
            <source>the patch would have folded or cut the surface at a few places</source>
            <translation>der Flicken hätte sich gefaltet oder an einigen Stellen die Fläche geschnitten</translation>
        </message>
        <message>
            <source>there, at %1 of its %2 vertices, it goes back towards what it set out from</source>
            <translation>dort, an %1 seiner %2 Ecken, kehrt er zu seinem Anfang zurück</translation>
        </message>
        <message>
            <source>a crease of %1 degrees is left at a seam</source>
            <translation>an einer Naht bleibt ein Knick von %1 Grad</translation>
        </message>
        <message>
            <source>the patch turns too sharply there for edges of this length</source>
            <translation>der Flicken biegt dort zu scharf für Kanten dieser Länge</translation>
        </message>
        <message>
            <source>finer meshes would help</source>
            <translation>feinere Netze würden helfen</translation>
        </message>
        <message>
            <source>the scan around the hole has no relief to continue</source>
            <translation>der Scan um das Loch hat kein Relief, das sich fortsetzen ließe</translation>
        </message>
        <message>
            <source>the patch has as much relief as the scan without any added, rms %1 (%2 around the hole)</source>
            <translation>der Flicken hat schon so viel Relief wie der Scan, quadratisches Mittel %1 (um das Loch %2)</translation>
        </message>
        <message>
            <source>with relief the patch would fold or cut the surface</source>
            <translation>mit Relief würde der Flicken sich falten oder die Fläche schneiden</translation>
        </message>
        <message>
            <source>it stays smooth</source>
            <translation>er bleibt glatt</translation>
        </message>
        <message>
            <source>relief continued at random, rms %1 (%2 around the hole)</source>
            <translation>zufälliges Relief fortgesetzt, quadratisches Mittel %1 (um das Loch %2)</translation>
        </message>
        <message>
            <source>no step of the flow came below its fairings, which were kept</source>
            <translation>kein Schritt des Flusses kam unter seine Glättungen, die behalten wurden</translation>
        </message>
        <message>
            <source>stopped early</source>
            <translation>früh beendet</translation>
        </message>
        <message>
            <source>the noise could not be carried into the patch</source>
            <translation>das Rauschen ließ sich nicht in den Flicken fortführen</translation>
        </message>
        <message>
            <source>only vanishing time steps keep the flow stable here</source>
            <translation>nur verschwindend kleine Zeitschritte halten den Fluss hier stabil</translation>
        </message>
        <message>
            <source>the flow has not converged, but only ever smaller steps lower the energy</source>
            <translation>der Fluss ist nicht konvergiert, aber nur immer kleinere Schritte senken die Energie</translation>
        </message>
        <message>
            <source>no further step lowers the energy without folding the patch</source>
            <translation>kein weiterer Schritt senkt die Energie, ohne den Flicken zu falten</translation>
        </message>
        <message>
            <source>the patch is too degenerate to be faired</source>
            <translation>der Flicken ist zu entartet, um geglättet zu werden</translation>
        </message>
        <message>
            <source>stopped after %1 steps, before the steady state</source>
            <translation>nach %1 Schritten angehalten, vor dem stationären Zustand</translation>
        </message>
        <message>
            <source>the surface around the hole has too few vertices to tell its curvature</source>
            <translation>die Fläche um das Loch hat zu wenige Ecken, um ihre Krümmung zu bestimmen</translation>
        </message>
        <message>
            <source>the patch has no free vertex to evolve</source>
            <translation>der Flicken hat keine freie Ecke, die sich bewegen könnte</translation>
        </message>
        <message>
            <source>the patch has a vertex that is not finite</source>
            <translation>der Flicken hat eine Ecke, die nicht endlich ist</translation>
        </message>
        <message>
            <source>a loop has no extent</source>
            <translation>ein Rand hat keine Ausdehnung</translation>
        </message>
        <message>
            <source>all its vertices are in one place</source>
            <translation>alle seine Ecken liegen an einem Ort</translation>
        </message>
        <message>
            <source>the density must lie between 0.1 and 10, not %1</source>
            <translation>die Dichte muss zwischen 0,1 und 10 liegen, nicht bei %1</translation>
        </message>
        <message>
            <source>the time step sigma must lie between 1e-6 and 1e8, not %1</source>
            <translation>der Zeitschritt σ muss zwischen 1e-6 und 1e8 liegen, nicht bei %1</translation>
        </message>
        <message>
            <source>the share of bending energy must lie between 0 and 1e6, not %1</source>
            <translation>der Anteil der Biegeenergie muss zwischen 0 und 1e6 liegen, nicht bei %1</translation>
        </message>
        <message>
            <source>the number of steps must be at least 1, not %1</source>
            <translation>die Zahl der Schritte muss mindestens 1 sein, nicht %1</translation>
        </message>
        <message>
            <source>It cuts the surface or itself in %1 places</source>
            <translation>Er schneidet die Fläche oder sich selbst an %1 Stellen</translation>
        </message>
        <message>
            <source>the command line leaves such a hole open</source>
            <translation>die Befehlszeile lässt ein solches Loch offen</translation>
        </message>
        <message>
            <source>Run a flow, or discard it and try another density</source>
            <translation>Einen Fluss laufen lassen, oder ihn verwerfen und eine andere Dichte versuchen</translation>
        </message>
        <message>
            <source>It folds over itself where the initial patch did not</source>
            <translation>Er faltet sich, wo der erste Flicken es nicht tat</translation>
        </message>
        <message>
            <source>the command line would keep the initial patch</source>
            <translation>die Befehlszeile behielte den ersten Flicken</translation>
        </message>
        <message>
            <source>Go back a few steps, or take smaller ones</source>
            <translation>Ein paar Schritte zurückgehen, oder kleinere tun</translation>
        </message>
        <message>
            <source>the region names vertex %1, but the vertices are 0 to %2</source>
            <translation>das Gebiet nennt Ecke %1, aber die Ecken sind 0 bis %2</translation>
        </message>
        <message>
            <source>the region takes in a whole piece of the surface</source>
            <translation>das Gebiet umfasst ein ganzes Stück der Fläche</translation>
        </message>
        <message>
            <source>nothing around it would hold it</source>
            <translation>nichts ringsum würde es halten</translation>
        </message>
        <message>
            <source>the region has no vertex that could move</source>
            <translation>das Gebiet hat keine Ecke, die sich bewegen könnte</translation>
        </message>
        <message>
            <source>it is empty, or lies on the surface's boundary</source>
            <translation>es ist leer oder liegt auf dem Rand der Fläche</translation>
        </message>
        <message>
            <source>%1 vertices of the region lie on the surface's boundary</source>
            <translation>%1 Ecken des Gebiets liegen auf dem Rand der Fläche</translation>
        </message>
        <message>
            <source>they stay</source>
            <translation>sie bleiben</translation>
        </message>
        <message>
            <source>the flow would leave %1 in the region</source>
            <translation>der Fluss ließe %1 im Gebiet zurück</translation>
        </message>
        <message>
            <source>no valid surface was found</source>
            <translation>es fand sich keine gültige Fläche</translation>
        </message>
        <message>
            <source>the best one has %1</source>
            <translation>die beste hat %1</translation>
        </message>
        <message>
            <source>all vertices of the polyhedron lie in one plane</source>
            <translation>alle Ecken des Polyeders liegen in einer Ebene</translation>
        </message>
        <message>
            <source>there is no surface to find between them</source>
            <translation>zwischen ihnen gibt es keine Fläche zu finden</translation>
        </message>
        <message>
            <source>the number of subdivisions must lie between 1 and 8, not %1</source>
            <translation>die Zahl der Unterteilungen muss zwischen 1 und 8 liegen, nicht bei %1</translation>
        </message>
        <message>
            <source>the polyhedron has %1 vertices</source>
            <translation>das Polyeder hat %1 Ecken</translation>
        </message>
        <message>
            <source>too few for a surface, at least 4 are needed</source>
            <translation>zu wenige für eine Fläche, mindestens 4 sind nötig</translation>
        </message>
        <message>
            <source>the polyhedron is no simple surface</source>
            <translation>das Polyeder ist keine einfache Fläche</translation>
        </message>
        <message>
            <source>edges with more than two faces, faces that meet at a vertex alone, or faces that are double or without area</source>
            <translation>Kanten mit mehr als zwei Flächen, Flächen, die sich nur an einer Ecke treffen, oder Flächen, die doppelt oder ohne Inhalt sind</translation>
        </message>
        <message>
            <source>First press Repair… in the tab Patch</source>
            <translation>Zuerst „Reparieren…“ im Reiter Flicken drücken</translation>
        </message>
        <message>
            <source>the subdivided polyhedron would have more than 4 million triangles</source>
            <translation>das unterteilte Polyeder hätte mehr als 4 Millionen Dreiecke</translation>
        </message>
        <message>
            <source>fewer subdivisions do</source>
            <translation>weniger Unterteilungen genügen</translation>
        </message>
        <message>
            <source>the polyhedron has %1 hole, the largest with %2 edges</source>
            <translation>das Polyeder hat %1 Loch, das größte mit %2 Kanten</translation>
        </message>
        <message>
            <source>the polyhedron has %1 holes, the largest with %2 edges</source>
            <translation>das Polyeder hat %1 Löcher, das größte mit %2 Kanten</translation>
        </message>
        <message>
            <source>close it, or tick Smooth boundaries</source>
            <translation>es schließen oder „Glatte Ränder“ ankreuzen</translation>
        </message>
        <message>
            <source>vertex %1 is to be fixed, but the vertices are 0 to %2</source>
            <translation>Ecke %1 soll fest sein, aber die Ecken sind 0 bis %2</translation>
        </message>
        <message>
            <source>%1 fixed vertices are too few for a surface</source>
            <translation>%1 feste Ecken sind zu wenige für eine Fläche</translation>
        </message>
        <message>
            <source>at least 4 are needed</source>
            <translation>mindestens 4 sind nötig</translation>
        </message>
        <message>
            <source>a closed curve needs at least 3 points, not %1</source>
            <translation>eine geschlossene Kurve braucht mindestens 3 Punkte, nicht %1</translation>
        </message>
        <message>
            <source>two neighbouring points of the curve lie in one place</source>
            <translation>zwei benachbarte Punkte der Kurve liegen an einem Ort</translation>
        </message>
        <message>
            <source>parts %1 and %2 overlap</source>
            <translation>die Teile %1 und %2 überschneiden sich</translation>
        </message>
        <message>
            <source>%1 pairs of their triangles cut each other</source>
            <translation>%1 Paare ihrer Dreiecke schneiden einander</translation>
        </message>
        <message>
            <source>Move them apart</source>
            <translation>Sie auseinander rücken</translation>
        </message>
        <message>
            <source>the patch is not an oriented manifold</source>
            <translation>der Flicken ist keine orientierte Mannigfaltigkeit</translation>
        </message>
        <message>
            <source>the patch has an open edge away from its boundary</source>
            <translation>der Flicken hat eine offene Kante abseits seines Randes</translation>
        </message>
        <message>
            <source>a boundary edge of the patch is not a boundary edge of the surface</source>
            <translation>eine Randkante des Flickens ist keine Randkante der Fläche</translation>
        </message>
        <message>
            <source>a chord of the patch is an edge of the surface already</source>
            <translation>eine Sehne des Flickens ist schon eine Kante der Fläche</translation>
        </message>
        <message>
            <source>face %1 names vertex %2, but there are %3</source>
            <translation>Fläche %1 nennt Ecke %2, aber es gibt %3</translation>
        </message>
        <message>
            <source>face %1 cannot be joined to its neighbours</source>
            <translation>Fläche %1 lässt sich nicht mit ihren Nachbarn verbinden</translation>
        </message>
        <message>
            <source>no usable face</source>
            <translation>keine brauchbare Fläche</translation>
        </message>
        <message>
            <source>every face is degenerate</source>
            <translation>jede Fläche ist entartet</translation>
        </message>
        <message>
            <source>this would leave no triangle of the surface</source>
            <translation>dann bliebe kein Dreieck der Fläche</translation>
        </message>
        <message>
            <source>loop %1 of %2 is filled already</source>
            <translation>Rand %1 von %2 ist schon gefüllt</translation>
        </message>
        <message>
            <source>discard its patch, or choose another loop</source>
            <translation>seinen Flicken verwerfen oder einen anderen Rand wählen</translation>
        </message>
        <message>
            <source>the surface outside the patches was changed</source>
            <translation>die Fläche außerhalb der Flicken wurde verändert</translation>
        </message>
        <message>
            <source>nothing is handed on</source>
            <translation>nichts wird weitergegeben</translation>
        </message>
        <message>
            <source>There is not enough memory for this</source>
            <translation>Dafür reicht der Speicher nicht</translation>
        </message>
        <message>
            <source>a number</source>
            <translation>eine Zahl</translation>
        </message>
        <message>
            <source>a whole number</source>
            <translation>eine ganze Zahl</translation>
        </message>
        <message>
            <source>a colour</source>
            <translation>eine Farbe</translation>
        </message>
        <message>
            <source>a list of %1 items</source>
            <translation>einer Liste von %1 Einträgen</translation>
        </message>
        <message>
            <source>the number of edges</source>
            <translation>die Zahl der Kanten</translation>
        </message>
        <message>
            <source>the number of a face's corners</source>
            <translation>die Zahl der Ecken einer Fläche</translation>
        </message>
        <message>
            <source>"count" or "componentType" is missing</source>
            <translation>„count“ oder „componentType“ fehlt</translation>
        </message>
        <message>
            <source>"buffer" or "byteLength" is missing</source>
            <translation>„buffer“ oder „byteLength“ fehlt</translation>
        </message>
        <message>
            <source>"count", "indices" or "values" is missing</source>
            <translation>„count“, „indices“ oder „values“ fehlt</translation>
        </message>
        <message>
            <source>removing loose crumbs in its way (Repair… in the tab Patch), Trim there or a strip across the hole (Bridge in the tab Tools) may help</source>
            <translation>„Beschneiden“ im Reiter Flicken, „Reparieren…“ ebendort (wenn lose Krümel im Weg sind) oder ein Streifen quer über das Loch („Brücke“ im Reiter Werkzeuge) kann helfen</translation>
        </message>
        <message>
            <source>bent past loose crumbs of surface in the hole</source>
            <translation>um lose Krümel im Loch herum gebogen</translation>
        </message>
        <message>
            <source>Repair… in the tab Patch removes such crumbs</source>
            <translation>„Reparieren…“ im Reiter Flicken entfernt solche Krümel</translation>
        </message>
        <message>
            <source>Trim crossing triangles in the menu Patch may help</source>
            <translation>„Kreuzende Dreiecke beschneiden“ im Menü Flicken kann helfen</translation>
        </message>
        <message>
            <source>the tolerance of stitching must be a length, not %1</source>
            <translation>die Toleranz beim Vernähen muss eine Länge sein, nicht %1</translation>
        </message>
        <message>
            <source>%1 edge of its patch would have more than two faces</source>
            <translation>%1 Kante seines Flickens hätte mehr als zwei Dreiecke</translation>
        </message>
        <message>
            <source>%1 edges of its patch would have more than two faces</source>
            <translation>%1 Kanten seines Flickens hätten mehr als zwei Dreiecke</translation>
        </message>
        <message>
            <source>the surface ends at this loop, which is flat, so that it was closed flat</source>
            <translation>die Fläche endet an diesem Rand, der flach ist; er wurde flach geschlossen</translation>
        </message>
        <message>
            <source>the surface ends at this loop, so that it was closed by a minimal surface</source>
            <translation>die Fläche endet an diesem Rand; er wurde durch eine Minimalfläche geschlossen</translation>
        </message>
        <message>
            <source>both surfaces end at these loops, so that a straight ring joins them</source>
            <translation>beide Flächen enden an diesen Rändern; ein gerader Ring verbindet sie</translation>
        </message>
        <message>
            <source>minimal surface over a cut</source>
            <translation>Minimalfläche über einem Schnitt</translation>
        </message>
        <message>
            <source>flow</source>
            <translation>Fluss</translation>
        </message>
        <message>
            <source>split flow</source>
            <translation>Fluss auf der glatten Fläche</translation>
        </message>
        <message>
            <source>robust fairing</source>
            <translation>robuste Glättung</translation>
        </message>
        <message>
            <source>tangent fairing</source>
            <translation>tangentiale Glättung</translation>
        </message>
        <message>
            <source>minimal surface</source>
            <translation>Minimalfläche</translation>
        </message>
        <message>
            <source>crosses the surface or itself in %1 places</source>
            <translation>schneidet die Fläche oder sich selbst an %1 Stellen</translation>
        </message>
        <message>
            <source>crosses the surface or itself in %1 place</source>
            <translation>schneidet die Fläche oder sich selbst an %1 Stelle</translation>
        </message>
        <message>
            <source>%1 edges have more than two faces</source>
            <translation>%1 Kanten haben mehr als zwei Flächen</translation>
        </message>
        <message>
            <source>%1 edge has more than two faces</source>
            <translation>%1 Kante hat mehr als zwei Flächen</translation>
        </message>
        <message>
            <source>%1 edges are folded by more than 150°</source>
            <translation>%1 Kanten sind um mehr als 150° gefaltet</translation>
        </message>
        <message>
            <source>%1 edge is folded by more than 150°</source>
            <translation>%1 Kante ist um mehr als 150° gefaltet</translation>
        </message>
        <message>
            <source>a crease of %1° along %2 edges of the seam, where the initial patch had %3°</source>
            <translation>ein Knick von %1° entlang %2 Kanten der Naht, wo der erste Flicken %3° hatte</translation>
        </message>
        <message>
            <source>a dome %1 diameters high over a flat loop</source>
            <translation>eine Kuppel, %1 Durchmesser hoch, über einem flachen Rand</translation>
        </message>
        <message>
            <source>a bubble of %1 times the area of the initial patch</source>
            <translation>eine Blase mit dem %1-Fachen der Fläche des ersten Flickens</translation>
        </message>
        <message>
            <source>a bubble of %1 times the area of the initial patch, reaching %2 diameters beyond it</source>
            <translation>eine Blase mit dem %1-Fachen der Fläche des ersten Flickens, die %2 Durchmesser darüber hinausreicht</translation>
        </message>
        <message>
            <source>mean curvature jumps at the seam by %1 / diameter, before the flow by %2</source>
            <translation>die mittlere Krümmung springt an der Naht um %1 / Durchmesser, vor dem Fluss um %2</translation>
        </message>
        <message>
            <source>the patch of the flow itself had a fault</source>
            <translation>der Flicken des Flusses selbst hatte einen Fehler</translation>
        </message>
        <message>
            <source>with bending energy mixed in it has none</source>
            <translation>mit beigemischter Biegeenergie hat er keinen</translation>
        </message>
        <message>
            <source>no step lowers the energy of the split any further</source>
            <translation>kein Schritt senkt die Energie der Zerlegung noch weiter</translation>
        </message>
        <message>
            <source>%1 sharp edge runs on across the hole</source>
            <translation>%1 scharfe Kante läuft über das Loch weiter</translation>
        </message>
        <message>
            <source>%1 sharp edges run on across the hole</source>
            <translation>%1 scharfe Kanten laufen über das Loch weiter</translation>
        </message>
        <message>
            <source>the surface of one side alone runs on here</source>
            <translation>hier läuft die Fläche einer Seite allein weiter</translation>
        </message>
        <message>
            <source>sharp edges continued in place of the flow</source>
            <translation>scharfe Kanten fortgesetzt statt des Flusses</translation>
        </message>
        <message>
            <source>initial patch over a cut</source>
            <translation>erster Flicken über einem Schnitt</translation>
        </message>
        <message>
            <source>sharp edges</source>
            <translation>scharfe Kanten</translation>
        </message>
        <message>
            <source>copied from the mirror image, from which the surface around is %1 diameters away</source>
            <translation>vom Spiegelbild kopiert, von dem die Fläche ringsum %1 Durchmesser entfernt ist</translation>
        </message>
        <message>
            <source>not copied from the mirror image, from which the surface around is %1 diameters away</source>
            <translation>nicht vom Spiegelbild kopiert, von dem die Fläche ringsum %1 Durchmesser entfernt ist</translation>
        </message>
        <message>
            <source>from a quadric it is %1</source>
            <translation>von einer Quadrik sind es %1</translation>
        </message>
        <message>
            <source>not copied from the mirror image, since the scan is not symmetric</source>
            <translation>nicht vom Spiegelbild kopiert, da der Scan nicht symmetrisch ist</translation>
        </message>
        <message>
            <source>its best image is %1 of its extent away</source>
            <translation>sein bestes Spiegelbild ist %1 seiner Ausdehnung entfernt</translation>
        </message>
        <message>
            <source>not copied from the mirror image, which has no surface there</source>
            <translation>nicht vom Spiegelbild kopiert, das dort keine Fläche hat</translation>
        </message>
        <message>
            <source>not copied from the mirror image, which folds there, cuts the surface or does not close the hole</source>
            <translation>nicht vom Spiegelbild kopiert, das sich dort faltet, die Fläche schneidet oder das Loch nicht schließt</translation>
        </message>
        <message>
            <source>without Sharp edges the flow runs</source>
            <translation>ohne „Scharfe Kanten“ läuft der Fluss</translation>
        </message>
        <message>
            <source>few triangles</source>
            <translation>wenige Dreiecke</translation>
        </message>
        <message>
            <source>too small for a flow</source>
            <translation>zu klein für einen Fluss</translation>
        </message>
        <message>
            <source>closed by triangles around one new vertex</source>
            <translation>mit Dreiecken um eine neue Ecke geschlossen</translation>
        </message>
    </context>
    <context>
        <name>loopmend::ExampleController</name>
        <message>
            <source>%1 %2</source>
            <translation>%1 %2</translation>
        </message>
        <message>
            <source>&amp;Run it</source>
            <translation>&amp;Laufen lassen</translation>
        </message>
        <message>
            <source>An example of the paper: %1.</source>
            <translation>Ein Beispiel des Aufsatzes: %1.</translation>
        </message>
    </context>
    <context>
        <name>loopmend::ExportDialog</name>
        <message>
            <source>Export</source>
            <translation>Export</translation>
        </message>
        <message>
            <source>Scan and patches</source>
            <translation>Scan und Flicken</translation>
        </message>
        <message>
            <source>Patches only</source>
            <translation>Nur die Flicken</translation>
        </message>
        <message>
            <source>What is written</source>
            <translation>Was geschrieben wird</translation>
        </message>
        <message>
            <source>The scan with its holes closed, or the patches by themselves</source>
            <translation>Der Scan mit geschlossenen Löchern oder die Flicken allein</translation>
        </message>
        <message>
            <source>&amp;Write:</source>
            <translation>&amp;Inhalt:</translation>
        </message>
        <message>
            <source>Printing:</source>
            <translation>Drucken:</translation>
        </message>
        <message>
            <source>Patches by themselves are open surfaces.</source>
            <translation>Flicken allein sind offene Flächen.</translation>
        </message>
        <message>
            <source>. Lengths are in the units of the scan.</source>
            <translation>. Längen sind in den Einheiten des Scans.</translation>
        </message>
        <message>
            <source>Looking for open edges and intersections…</source>
            <translation>Offene Kanten und Überschneidungen werden gesucht…</translation>
        </message>
        <message>
            <source>. Lengths are in %1.</source>
            <translation>. Längen in %1.</translation>
        </message>
        <message numerus="yes">
            <source>%Ln hidden piece(s) or patch(es) are written as well.</source>
            <translation>
                <numerusform>%Ln ausgeblendetes Teil wird mitgeschrieben.</numerusform>
                <numerusform>%Ln ausgeblendete Teile werden mitgeschrieben.</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>loopmend::FileController</name>
        <message>
            <source>Work on %1 is neither saved nor exported.</source>
            <translation>Die Arbeit an %1 ist weder gespeichert noch exportiert.</translation>
        </message>
        <message>
            <source>&amp;Save session</source>
            <translation>Sitzung &amp;speichern</translation>
        </message>
        <message>
            <source>&amp;Cancel</source>
            <translation>Abb&amp;rechen</translation>
        </message>
        <message>
            <source>&amp;Open without saving</source>
            <translation>Ohne Speichern &amp;öffnen</translation>
        </message>
        <message>
            <source>Add scans to the scene</source>
            <translation>Scans zur Szene hinzufügen</translation>
        </message>
        <message>
            <source>Open</source>
            <translation>Öffnen</translation>
        </message>
        <message>
            <source>Scans and sessions (*.ply *.stl *.obj *.off *.glb *.gltf *.3mf *.gz *.loopmend *.PLY *.STL *.OBJ *.OFF *.GLB *.GLTF *.3MF);;All files (*)</source>
            <translation>Scans und Sitzungen (*.ply *.stl *.obj *.off *.glb *.gltf *.3mf *.gz *.loopmend *.PLY *.STL *.OBJ *.OFF *.GLB *.GLTF *.3MF);;Alle Dateien (*)</translation>
        </message>
        <message>
            <source>PLY (*.ply);;STL (*.stl);;OBJ (*.obj);;OFF (*.off);;glTF (*.glb);;glTF text (*.gltf);;3MF (*.3mf)</source>
            <translation>PLY (*.ply);;STL (*.stl);;OBJ (*.obj);;OFF (*.off);;glTF (*.glb);;glTF text (*.gltf);;3MF (*.3mf)</translation>
        </message>
        <message numerus="yes">
            <source>%Ln hole(s) closed by an initial patch: no flow has smoothed it yet.</source>
            <translation>
                <numerusform>%Ln Loch ist mit einem ersten Flicken geschlossen: kein Fluss hat ihn geglättet.</numerusform>
                <numerusform>%Ln Löcher sind mit ersten Flicken geschlossen: kein Fluss hat sie geglättet.</numerusform>
            </translation>
        </message>
        <message>
            <source>&amp;Smooth, then export</source>
            <translation>&amp;Glätten, dann exportieren</translation>
        </message>
        <message>
            <source>E&amp;xport as they are</source>
            <translation>E&amp;xportieren, wie sie sind</translation>
        </message>
        <message>
            <source>&amp;Close without saving</source>
            <translation>Ohne Speichern s&amp;chließen</translation>
        </message>
        <message>
            <source>&amp;Quit without saving</source>
            <translation>Ohne Speichern &amp;beenden</translation>
        </message>
        <message>
            <source>The result of the tool was not accepted yet.</source>
            <translation>Das Ergebnis des Werkzeugs wurde noch nicht übernommen.</translation>
        </message>
        <message>
            <source>&amp;Close without it</source>
            <translation>Ohne es &amp;schließen</translation>
        </message>
        <message>
            <source>Loopmend ended unexpectedly. Work was kept: %1.</source>
            <translation>Loopmend wurde unerwartet beendet. Die Arbeit ist noch da: %1.</translation>
        </message>
        <message>
            <source>&amp;Recover</source>
            <translation>Wiede&amp;rherstellen</translation>
        </message>
        <message>
            <source>&amp;Discard</source>
            <translation>&amp;Verwerfen</translation>
        </message>
        <message>
            <source>&amp;Later</source>
            <translation>&amp;Später</translation>
        </message>
        <message>
            <source>recovered work</source>
            <translation>wiederhergestellte Arbeit</translation>
        </message>
        <message>
            <source>Where is %1?</source>
            <translation>Wo ist %1?</translation>
        </message>
        <message>
            <source>%1 needs %2, which is not there any more.</source>
            <translation>%1 braucht %2; dort ist die Datei nicht mehr.</translation>
        </message>
        <message>
            <source>&amp;Locate…</source>
            <translation>&amp;Suchen…</translation>
        </message>
        <message>
            <source>&amp;%1  %2</source>
            <translation>&amp;%1  %2</translation>
        </message>
        <message>
            <source>Nothing yet</source>
            <translation>Noch nichts</translation>
        </message>
        <message>
            <source>&amp;Forget these</source>
            <translation>Diese &amp;vergessen</translation>
        </message>
        <message>
            <source>Nothing is open</source>
            <translation>Nichts ist offen</translation>
        </message>
    </context>
    <context>
        <name>loopmend::FillBox</name>
        <message>
            <source>Density</source>
            <translation>Dichte</translation>
        </message>
        <message>
            <source>Density of the patch relative to the scan around it; 2 halves the edge length</source>
            <translation>Dichte des Flickens im Verhältnis zum Scan ringsum; 2 halbiert die Kantenlänge</translation>
        </message>
        <message>
            <source>Preview</source>
            <translation>Vorschau</translation>
        </message>
        <message>
            <source>Open a scan first.</source>
            <translation>Zuerst einen Scan öffnen.</translation>
        </message>
        <message>
            <source>%1, selected</source>
            <translation>%1, ausgewählt</translation>
        </message>
        <message>
            <source>The selection is filled already.</source>
            <translation>Die Auswahl ist schon gefüllt.</translation>
        </message>
        <message>
            <source>No open hole is left.</source>
            <translation>Kein Loch ist mehr offen.</translation>
        </message>
        <message>
            <source>Show the patch with its edges before it is made; for up to 200 holes at once</source>
            <translation>Den Flicken mit seinen Kanten zeigen, bevor er gemacht wird; für bis zu 200 Löcher auf einmal</translation>
        </message>
        <message>
            <source>Join islands</source>
            <translation>Inseln anschließen</translation>
        </message>
        <message>
            <source>Join pieces of surface that lie within a hole to its patch; otherwise the patch covers them</source>
            <translation>Flächenstücke, die in einem Loch liegen, an den Flicken anschließen; sonst überdeckt er sie</translation>
        </message>
        <message>
            <source>Remove dangling, folded, needle-like and crossing triangles at the boundaries of these holes, up to three rings of them, before they are filled; Ctrl+Z brings them back</source>
            <translation>Hängende, gefaltete, nadelförmige und schneidende Dreiecke an den Rändern dieser Löcher entfernen, bis zu drei Ringe davon, bevor sie gefüllt werden; Strg+Z holt sie zurück</translation>
        </message>
        <message>
            <source>Zip boundaries that lie within a tenth of their edges of each other, such as cracks and the seams between tiles; Ctrl+Z takes it back</source>
            <translation>Ränder schließen, die nicht weiter als ein Zehntel ihrer Kanten auseinander liegen, etwa Risse und die Nähte zwischen Kacheln; Strg+Z macht es rückgängig</translation>
        </message>
        <message>
            <source>1  Fill and smooth</source>
            <translation>1  Füllen und glätten</translation>
        </message>
        <message>
            <source>Close the selected holes, or all holes when none is selected, and let the flow run to its steady state (Ctrl+F)</source>
            <translation>Die gewählten Löcher schließen, oder alle, wenn keines gewählt ist, und den Fluss laufen lassen, bis er ruht (Strg+F)</translation>
        </message>
        <message>
            <source>Close the holes by their initial patches, and let no flow run yet (Ctrl+Shift+F)</source>
            <translation>Die Löcher durch ihre ersten Flicken schließen und noch keinen Fluss laufen lassen (Strg+Umschalt+F)</translation>
        </message>
        <message>
            <source>What is wrong with the scan, each with its count and a button: vertices to be joined, degenerate, duplicate and intersecting faces, non-manifold edges, crumbs</source>
            <translation>Was am Scan nicht stimmt, jeweils mit Anzahl und Knopf: Ecken zum Verbinden, entartete, doppelte und sich schneidende Flächen, nicht-mannigfaltige Kanten, Krümel</translation>
        </message>
        <message>
            <source>To fill one that is left out, select it.</source>
            <translation>Ausgelassene: auswählen, dann füllen.</translation>
        </message>
        <message>
            <source>%1–%2</source>
            <translation>%1–%2</translation>
        </message>
        <message>
            <source>≈ %1 triangles, edges %2</source>
            <translation>≈ %1 Dreiecke, Kanten %2</translation>
        </message>
        <message>
            <source>A cut is no hole to be filled.</source>
            <translation>Ein Schnitt ist kein Loch zum Füllen.</translation>
        </message>
        <message>
            <source>Stitch joins the sides of a crack.</source>
            <translation>Vernähen verbindet einen Riss.</translation>
        </message>
        <message>
            <source>Not fillable as it is: press Trim.</source>
            <translation>So nicht füllbar: Beschneiden.</translation>
        </message>
        <message>
            <source>Repair… removes such edges.</source>
            <translation>Reparieren… entfernt solche Kanten.</translation>
        </message>
        <message>
            <source>It cuts the surface: Discard, then Trim.</source>
            <translation>Schneidet: Verwerfen, dann Beschneiden.</translation>
        </message>
        <message>
            <source>Stitch</source>
            <translation>Vernähen</translation>
        </message>
        <message>
            <source>Trim</source>
            <translation>Beschneiden</translation>
        </message>
        <message>
            <source>Repair…</source>
            <translation>Reparieren…</translation>
        </message>
        <message>
            <source>Fill and smooth</source>
            <translation>Füllen und glätten</translation>
        </message>
        <message>
            <source>Initial patch only</source>
            <translation>Nur erster Flicken</translation>
        </message>
        <message>
            <source>Smooth</source>
            <translation>Glätten</translation>
        </message>
        <message numerus="yes">
            <source>%Ln crack(s): press Stitch.</source>
            <translation>
                <numerusform>%Ln Riss: Vernähen drücken.</numerusform>
                <numerusform>%Ln Risse: Vernähen drücken.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>Stitch %Ln crack(s)</source>
            <translation>
                <numerusform>%Ln Riss vernähen</numerusform>
                <numerusform>%Ln Risse vernähen</numerusform>
            </translation>
        </message>
        <message>
            <source>All open holes (%L1)</source>
            <translation>Alle offenen Löcher (%L1)</translation>
        </message>
        <message numerus="yes">
            <source>%Ln patch(es) cut the surface.</source>
            <translation>
                <numerusform>%Ln Flicken schneidet die Fläche.</numerusform>
                <numerusform>%Ln Flicken schneiden die Fläche.</numerusform>
            </translation>
        </message>
        <message>
            <source>Select one: Discard, then Trim.</source>
            <translation>Einen wählen: Verwerfen, dann Beschneiden.</translation>
        </message>
        <message>
            <source>A crease at the seam? Discard, then Trim, or erase a ring of faces.</source>
            <translation>Ein Knick an der Naht? Verwerfen, dann Beschneiden oder einen Ring löschen.</translation>
        </message>
        <message numerus="yes">
            <source>%Ln cut(s): press Repair…</source>
            <translation>
                <numerusform>%Ln Schnitt: Reparieren… drücken.</numerusform>
                <numerusform>%Ln Schnitte: Reparieren… drücken.</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>loopmend::FillController</name>
        <message>
            <source>Filling %1</source>
            <translation>Füllen: %1</translation>
        </message>
        <message>
            <source>Trim the boundaries of %1</source>
            <translation>Ränder von %1 beschneiden</translation>
        </message>
        <message>
            <source>Fill %1</source>
            <translation>Füllen: %1</translation>
        </message>
        <message>
            <source>Filled %1 with %2 triangles in %3 s.</source>
            <translation>Gefüllt: %1, mit %2 Dreiecken in %3 s.</translation>
        </message>
        <message>
            <source>Some of these holes lie so close to filled ones that both were filled anew, as one.</source>
            <translation>Einige dieser Löcher liegen so nah an gefüllten, dass beide zusammen neu gefüllt wurden.</translation>
        </message>
        <message>
            <source>Hole %1: %2</source>
            <translation>Loch %1: %2</translation>
        </message>
        <message>
            <source>Hole %1 stays open: %2</source>
            <translation>Loch %1 bleibt offen: %2</translation>
        </message>
        <message>
            <source>%1 step on %2</source>
            <translation>%1, ein Schritt: %2</translation>
        </message>
        <message>
            <source>%1 on %2</source>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>%1 could not be solved together; each was solved by itself.</source>
            <translation>%1 ließen sich nicht gemeinsam lösen; jedes wurde für sich gelöst.</translation>
        </message>
        <message>
            <source>Taking over %1</source>
            <translation>%1 wird übernommen</translation>
        </message>
        <message>
            <source>Pausing after this step</source>
            <translation>Hält nach diesem Schritt an</translation>
        </message>
        <message>
            <source>Cancelled; the last accepted state is kept.</source>
            <translation>Abgebrochen; der letzte gültige Zustand bleibt.</translation>
        </message>
        <message>
            <source>Cancelled.</source>
            <translation>Abgebrochen.</translation>
        </message>
        <message>
            <source>Accept %1</source>
            <translation>Annehmen: %1</translation>
        </message>
        <message>
            <source>Go back on %1</source>
            <translation>Zurückgehen: %1</translation>
        </message>
        <message>
            <source>Opening %1</source>
            <translation>Öffnen: %1</translation>
        </message>
        <message>
            <source>Opening %1 files</source>
            <translation>%1 Dateien werden geöffnet</translation>
        </message>
        <message>
            <source>Making the sample</source>
            <translation>Das Beispiel wird gemacht</translation>
        </message>
        <message>
            <source> Opened in %1 s.</source>
            <translation> In %1 s geöffnet.</translation>
        </message>
        <message>
            <source>Computing curvature</source>
            <translation>Krümmung wird berechnet</translation>
        </message>
        <message>
            <source>Add %1</source>
            <translation>Hinzufügen: %1</translation>
        </message>
        <message>
            <source>Close %1</source>
            <translation>Schließen: %1</translation>
        </message>
        <message>
            <source>Writing %1</source>
            <translation>Schreiben: %1</translation>
        </message>
        <message>
            <source>Saved the session as %1.</source>
            <translation>Sitzung gespeichert als %1.</translation>
        </message>
        <message>
            <source>Wrote %1: %2 triangles.</source>
            <translation>%1 geschrieben: %2 Dreiecke.</translation>
        </message>
        <message>
            <source> Not in it: %1.</source>
            <translation> Nicht darin: %1.</translation>
        </message>
        <message>
            <source> STL rounds: vertices were moved by up to %1; PLY keeps every digit.</source>
            <translation> STL rundet: Ecken wurden um bis zu %1 verschoben; PLY behält jede Stelle.</translation>
        </message>
        <message>
            <source> Left open, because the patch cuts the surface or another patch: %1.</source>
            <translation> Offen gelassen, weil der Flicken die Fläche oder einen anderen schneidet: %1.</translation>
        </message>
        <message>
            <source>%1: %2 vertices were joined to others, %3 faces split; Ctrl+Z takes it back.</source>
            <translation>%1: %2 Ecken wurden mit anderen verbunden, %3 Dreiecke geteilt; Strg+Z macht es rückgängig.</translation>
        </message>
        <message>
            <source>Stitch %1</source>
            <translation>%1 vernähen</translation>
        </message>
        <message>
            <source>Repair %1</source>
            <translation>%1 reparieren</translation>
        </message>
        <message>
            <source>No boundaries lie close enough together to be stitched.</source>
            <translation>Keine Ränder liegen nah genug beieinander, um vernäht zu werden.</translation>
        </message>
        <message>
            <source>There is nothing to repair.</source>
            <translation>Es gibt nichts zu reparieren.</translation>
        </message>
        <message>
            <source>Trimming boundaries</source>
            <translation>Ränder beschneiden</translation>
        </message>
        <message>
            <source>Stitching boundaries</source>
            <translation>Ränder vernähen</translation>
        </message>
        <message>
            <source>Repairing the scan</source>
            <translation>Scan reparieren</translation>
        </message>
        <message>
            <source>%1: a bridge was laid between the vertices %2 and %3; Ctrl+Z takes it back.</source>
            <translation>%1: Zwischen den Ecken %2 und %3 wurde eine Brücke gelegt; Strg+Z nimmt sie zurück.</translation>
        </message>
        <message>
            <source>Bridge a hole of %1</source>
            <translation>Loch von %1 überbrücken</translation>
        </message>
        <message>
            <source>Bridging a hole</source>
            <translation>Loch wird überbrückt</translation>
        </message>
        <message>
            <source>Fill and smooth %1</source>
            <translation>%1 füllen und glätten</translation>
        </message>
        <message>
            <source>%1: %2. Ctrl+Z takes it back.</source>
            <translation>%1: %2. Strg+Z nimmt es zurück.</translation>
        </message>
        <message>
            <source>Discard %1</source>
            <translation>Verwerfen: %1</translation>
        </message>
        <message>
            <source>No hole was made that could be filled: what was erased lay at an outer rim, or was a whole piece.</source>
            <translation>Es entstand kein Loch, das sich füllen ließe: was gelöscht wurde, lag an einem Außenrand oder war ein ganzes Stück.</translation>
        </message>
        <message>
            <source>Fill a part of a hole of %1</source>
            <translation>Einen Teil eines Lochs von %1 füllen</translation>
        </message>
        <message>
            <source>Erase a region of %1</source>
            <translation>Ein Gebiet von %1 löschen</translation>
        </message>
        <message>
            <source>Part a boundary of %1</source>
            <translation>Einen Rand von %1 teilen</translation>
        </message>
        <message>
            <source>No vertex was found at which the boundary could be parted.</source>
            <translation>Es fand sich keine Ecke, an der sich der Rand teilen ließe.</translation>
        </message>
        <message>
            <source>Erasing a region</source>
            <translation>Ein Gebiet wird gelöscht</translation>
        </message>
        <message>
            <source>Parting a boundary</source>
            <translation>Ein Rand wird geteilt</translation>
        </message>
        <message>
            <source>Lengths in %1</source>
            <translation>Längen in %1</translation>
        </message>
        <message>
            <source>Lengths without a unit</source>
            <translation>Längen ohne Einheit</translation>
        </message>
        <message>
            <source>Erase a ring of faces of %1</source>
            <translation>Einen Ring von Flächen von %1 löschen</translation>
        </message>
        <message>
            <source>%1 is closed: it has no hole to fill.</source>
            <translation>%1 ist geschlossen: es gibt kein Loch zu füllen.</translation>
        </message>
        <message>
            <source>Open again: %1</source>
            <translation>Wieder öffnen: %1</translation>
        </message>
        <message>
            <source>%1, %2: %3 steps</source>
            <translation>%1, %2: %3 Schritte</translation>
        </message>
        <message>
            <source>, J %1 → %2</source>
            <translation>, J %1 → %2</translation>
        </message>
        <message>
            <source>, energy %1 → %2</source>
            <translation>, Energie %1 → %2</translation>
        </message>
        <message>
            <source>, %1 s.</source>
            <translation>, %1 s.</translation>
        </message>
        <message>
            <source>%1 ask for different smoothing, so that they become %2 patches.</source>
            <translation>%1 verlangen verschiedene Glättung und werden darum %2 Flicken.</translation>
        </message>
        <message>
            <source>Trim crossing triangles of %1</source>
            <translation>%1: kreuzende Dreiecke beschneiden</translation>
        </message>
        <message>
            <source>No edge of these boundaries runs through the surface.</source>
            <translation>Keine Kante dieser Ränder läuft durch die Fläche.</translation>
        </message>
        <message>
            <source>Trimming crossing triangles</source>
            <translation>Kreuzende Dreiecke entfernen</translation>
        </message>
        <message>
            <source>There are no bad triangles at these boundaries. A right click on the hole offers to erase a ring of faces.</source>
            <translation>An diesen Rändern gibt es keine schlechten Dreiecke. Ein Rechtsklick auf das Loch bietet an, einen Ring von Flächen zu löschen.</translation>
        </message>
        <message numerus="yes">
            <source>%Ln more</source>
            <translation>
                <numerusform>%Ln weiterer</numerusform>
                <numerusform>%Ln weitere</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln patch(es) are a part of the scan now.</source>
            <translation>
                <numerusform>%Ln Flicken ist jetzt ein Teil des Scans.</numerusform>
                <numerusform>%Ln Flicken sind jetzt ein Teil des Scans.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1 %Ln patch(es) of this scan were removed.</source>
            <translation>
                <numerusform>%1 %Ln Flicken dieses Scans wurde entfernt.</numerusform>
                <numerusform>%1 %Ln Flicken dieses Scans wurden entfernt.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1: %Ln triangle(s) were removed where a boundary ran through the surface; Ctrl+Z brings them back.</source>
            <translation>
                <numerusform>%1: %Ln Dreieck wurde entfernt, wo ein Rand durch die Fläche lief; Strg+Z bringt es zurück.</numerusform>
                <numerusform>%1: %Ln Dreiecke wurden entfernt, wo ein Rand durch die Fläche lief; Strg+Z bringt sie zurück.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln vertices joined</source>
            <translation>
                <numerusform>%Ln Ecke verbunden</numerusform>
                <numerusform>%Ln Ecken verbunden</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln degenerate faces removed</source>
            <translation>
                <numerusform>%Ln entartete Fläche entfernt</numerusform>
                <numerusform>%Ln entartete Flächen entfernt</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln duplicate faces removed</source>
            <translation>
                <numerusform>%Ln doppelte Fläche entfernt</numerusform>
                <numerusform>%Ln doppelte Flächen entfernt</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln intersecting faces cut out</source>
            <translation>
                <numerusform>%Ln schneidende Fläche ausgeschnitten</numerusform>
                <numerusform>%Ln schneidende Flächen ausgeschnitten</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln edges separated</source>
            <translation>
                <numerusform>%Ln Kante getrennt</numerusform>
                <numerusform>%Ln Kanten getrennt</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln vertices separated</source>
            <translation>
                <numerusform>%Ln Ecke getrennt</numerusform>
                <numerusform>%Ln Ecken getrennt</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln faces turned</source>
            <translation>
                <numerusform>%Ln Fläche gewendet</numerusform>
                <numerusform>%Ln Flächen gewendet</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln loose crumbs removed</source>
            <translation>
                <numerusform>%Ln loser Krümel entfernt</numerusform>
                <numerusform>%Ln lose Krümel entfernt</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1: %Ln face(s) were erased; Ctrl+Z brings them back.</source>
            <translation>
                <numerusform>%1: %Ln Fläche wurde gelöscht; Strg+Z holt sie zurück.</numerusform>
                <numerusform>%1: %Ln Flächen wurden gelöscht; Strg+Z holt sie zurück.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1: the boundary was parted at %Ln vertices; Ctrl+Z takes it back.</source>
            <translation>
                <numerusform>%1: der Rand wurde an %Ln Ecke geteilt; Strg+Z nimmt es zurück.</numerusform>
                <numerusform>%1: der Rand wurde an %Ln Ecken geteilt; Strg+Z nimmt es zurück.</numerusform>
            </translation>
        </message>
        <message>
            <source>%L1 of %L2 holes could not be filled. The State column says why, and what may help.</source>
            <translation>%L1 von %L2 Löchern ließen sich nicht füllen. Die Spalte Zustand sagt, warum und was helfen kann.</translation>
        </message>
        <message>
            <source>Restored %1: %L2 patches, in %3 s.</source>
            <translation>%1 wiederhergestellt: %L2 Flicken, in %3 s.</translation>
        </message>
        <message>
            <source>%1: %L2 bad triangles were removed at the boundaries; Ctrl+Z brings them back.</source>
            <translation>%1: %L2 schlechte Dreiecke wurden an den Rändern entfernt; Strg+Z holt sie zurück.</translation>
        </message>
        <message numerus="yes">
            <source>%Ln tiny handles cut open</source>
            <translation>
                <numerusform>%Ln winziger Henkel aufgeschnitten</numerusform>
                <numerusform>%Ln winzige Henkel aufgeschnitten</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>loopmend::FlowBox</name>
        <message>
            <source>Which geometric flow moves the patch, and so how far the seam is matched</source>
            <translation>Welcher geometrische Fluss den Flicken bewegt, und damit, wie weit die Naht passt</translation>
        </message>
        <message>
            <source>Time step</source>
            <translation>Zeitschritt</translation>
        </message>
        <message>
            <source>The selection is not filled yet.</source>
            <translation>Die Auswahl ist noch nicht gefüllt.</translation>
        </message>
        <message>
            <source>Nothing is filled yet.</source>
            <translation>Noch ist nichts gefüllt.</translation>
        </message>
        <message>
            <source>σ = %1</source>
            <translation>σ = %1</translation>
        </message>
        <message>
            <source>Pausing…</source>
            <translation>Hält an…</translation>
        </message>
        <message>
            <source>Two to four flows from one start, side by side, in a window of their own (C)</source>
            <translation>Zwei bis vier Flüsse von einem Anfang, nebeneinander in einem eigenen Fenster (C)</translation>
        </message>
        <message>
            <source>2  Flow</source>
            <translation>2  Fluss</translation>
        </message>
        <message>
            <source>Time step σ of Step, without a unit: 1 is one decay time of the slowest wave on this patch</source>
            <translation>Zeitschritt σ von Schritt, ohne Einheit: 1 ist eine Abklingzeit der langsamsten Welle auf diesem Flicken</translation>
        </message>
        <message>
            <source>One time step of the flow itself, the boundary taken literally: on rough scans it may lead away from the surface (S)</source>
            <translation>Ein Zeitschritt des Flusses selbst, mit dem Rand, wie er ist: auf rauen Scans kann er von der Fläche wegführen (S)</translation>
        </message>
        <message>
            <source>The same as Smooth, every step shown for a moment; again: pause (Space)</source>
            <translation>Dasselbe wie Glätten, jeder Schritt einen Augenblick lang gezeigt; noch einmal: anhalten (Leertaste)</translation>
        </message>
        <message>
            <source>When the patch is done, it gets random relief as strong as that of the scan around the hole. Off: it continues the smooth surface under the scan.</source>
            <translation>Der fertige Flicken bekommt ein zufälliges Relief, so stark wie das des Scans um das Loch. Aus: Er setzt die glatte Fläche unter dem Scan fort.</translation>
        </message>
        <message>
            <source>Continue relief</source>
            <translation>Relief fortsetzen</translation>
        </message>
        <message>
            <source>Accepted; open it again to go on.</source>
            <translation>Angenommen; erst wieder öffnen.</translation>
        </message>
        <message>
            <source>Boundary</source>
            <translation>Rand</translation>
        </message>
        <message>
            <source>Continuity</source>
            <translation>Übergang</translation>
        </message>
        <message>
            <source>Step</source>
            <translation>Schritt</translation>
        </message>
        <message>
            <source>Run</source>
            <translation>Lauf</translation>
        </message>
        <message>
            <source>Compare flows…</source>
            <translation>Flüsse vergleichen…</translation>
        </message>
        <message>
            <source>Pause</source>
            <translation>Pause</translation>
        </message>
        <message>
            <source>Sharp edges that end at the hole run on across it, where both sides say how. Off: one smooth patch.</source>
            <translation>Scharfe Kanten, die am Loch enden, laufen darüber weiter, wo beide Seiten zeigen, wie. Aus: ein glatter Flicken.</translation>
        </message>
        <message>
            <source>Sharp edges</source>
            <translation>Scharfe Kanten</translation>
        </message>
    </context>
    <context>
        <name>loopmend::FlowView</name>
        <message>
            <source>start</source>
            <translation>Anfang</translation>
        </message>
        <message>
            <source>step %1</source>
            <translation>Schritt %1</translation>
        </message>
        <message>
            <source>stopped at step %1</source>
            <translation>angehalten bei Schritt %1</translation>
        </message>
        <message>
            <source>converged, %1 steps</source>
            <translation>konvergiert, %1 Schritte</translation>
        </message>
        <message>
            <source>faired, %1 steps</source>
            <translation>geglättet, %1 Schritte</translation>
        </message>
        <message>
            <source>stopped early, step %1</source>
            <translation>vorzeitig beendet, Schritt %1</translation>
        </message>
        <message>
            <source>%1 steps</source>
            <translation>%1 Schritte</translation>
        </message>
        <message>
            <source>Accept</source>
            <translation>Annehmen</translation>
        </message>
        <message>
            <source>Flow</source>
            <translation>Fluss</translation>
        </message>
        <message>
            <source>Which flow this view shows</source>
            <translation>Welchen Fluss dieses Bild zeigt</translation>
        </message>
        <message>
            <source> · ∫|∇H|² %1</source>
            <translation> · ∫|∇H|² %1</translation>
        </message>
        <message>
            <source>Energy ∫|∇H|² %1</source>
            <translation>Energie ∫|∇H|² %1</translation>
        </message>
        <message>
            <source> · %1° · ΔH %2</source>
            <translation> · %1° · ΔH %2</translation>
        </message>
        <message>
            <source>At the seam: angle %1° (rms), jump of H %2 (rms)</source>
            <translation>An der Naht: Winkel %1°, Sprung von H %2 (quadratische Mittel)</translation>
        </message>
        <message>
            <source>Run the flows first</source>
            <translation>Zuerst die Flüsse laufen lassen</translation>
        </message>
        <message>
            <source>Put this result into the document; can be undone</source>
            <translation>Dieses Ergebnis ins Dokument übernehmen; lässt sich rückgängig machen</translation>
        </message>
        <message>
            <source>all %1 steps taken</source>
            <translation>alle %1 Schritte getan</translation>
        </message>
    </context>
    <context>
        <name>loopmend::Gallery</name>
        <message>
            <source>Cylinder</source>
            <translation>Zylinder</translation>
        </message>
        <message>
            <source>Sphere</source>
            <translation>Kugel</translation>
        </message>
        <message>
            <source>Three tubes</source>
            <translation>Drei Rohre</translation>
        </message>
        <message>
            <source>Six tubes</source>
            <translation>Sechs Rohre</translation>
        </message>
        <message>
            <source>T piece</source>
            <translation>T-Stück</translation>
        </message>
        <message>
            <source>Head</source>
            <translation>Kopf</translation>
        </message>
        <message>
            <source>Dodecahedron</source>
            <translation>Dodekaeder</translation>
        </message>
        <message>
            <source>Flows, tubes</source>
            <translation>Flüsse, Rohre</translation>
        </message>
        <message>
            <source>Flows, graph</source>
            <translation>Flüsse, Graph</translation>
        </message>
        <message>
            <source>A cylinder with parts missing</source>
            <translation>Ein Zylinder, dem Teile fehlen</translation>
        </message>
        <message>
            <source>A wire-frame of a sphere with eight openings</source>
            <translation>Ein Drahtgerüst einer Kugel mit acht Öffnungen</translation>
        </message>
        <message>
            <source>Three tubes that form a T</source>
            <translation>Drei Rohre, die ein T bilden</translation>
        </message>
        <message>
            <source>A head-like mesh with holes in nose, face and jaw</source>
            <translation>Ein kopfartiges Netz mit Löchern in Nase, Gesicht und Kiefer</translation>
        </message>
        <message>
            <source>A dodecahedron</source>
            <translation>Ein Dodekaeder</translation>
        </message>
        <message>
            <source>MMCVF, SDF and WF on the six tubes</source>
            <translation>MMCVF, SDF und WF an den sechs Rohren</translation>
        </message>
        <message>
            <source>The graph of a function: MCF, SDF, WF and MMCVF</source>
            <translation>Der Graph einer Funktion: MCF, SDF, WF und MMCVF</translation>
        </message>
        <message>
            <source>%1. A click opens it, a second one runs it</source>
            <translation>%1. Ein Klick öffnet es, ein zweiter lässt es laufen</translation>
        </message>
    </context>
    <context>
        <name>loopmend::HelpWindow</name>
        <message>
            <source>First steps</source>
            <translation>Erste Schritte</translation>
        </message>
        <message>
            <source>Holes</source>
            <translation>Löcher</translation>
        </message>
        <message>
            <source>Patch and flow</source>
            <translation>Flicken und Fluss</translation>
        </message>
        <message>
            <source>Looking at curvature</source>
            <translation>Krümmung ansehen</translation>
        </message>
        <message>
            <source>Inspecting the seam</source>
            <translation>Die Naht prüfen</translation>
        </message>
        <message>
            <source>Files, sessions, recovery</source>
            <translation>Dateien, Sitzungen, Wiederherstellung</translation>
        </message>
        <message>
            <source>When something goes wrong</source>
            <translation>Wenn etwas schiefgeht</translation>
        </message>
        <message>
            <source>Help</source>
            <translation>Hilfe</translation>
        </message>
        <message>
            <source>Pages</source>
            <translation>Seiten</translation>
        </message>
        <message>
            <source>The pages of the help</source>
            <translation>Die Seiten der Hilfe</translation>
        </message>
        <message>
            <source>Page</source>
            <translation>Seite</translation>
        </message>
        <message>
            <source>Compare, region, points, blend, bridge, distance</source>
            <translation>Vergleichen, Gebiet, Punkte, Verbinden, Brücke, Abstand</translation>
        </message>
    </context>
    <context>
        <name>loopmend::HoleTable</name>
        <message>
            <source>How far the scan around the hole can be trusted, known once the hole is filled: smooth, noisy or rough</source>
            <translation>Wie weit man dem Scan um das Loch trauen kann, bekannt, sobald das Loch gefüllt ist: glatt, verrauscht oder rau</translation>
        </message>
        <message>
            <source>The loop's number within its scan, by falling perimeter</source>
            <translation>Die Nummer innerhalb des Scans, nach fallendem Umfang</translation>
        </message>
        <message>
            <source>Hole, outer rim of a sheet, crack, ...</source>
            <translation>Loch, Außenrand, Riss, ...</translation>
        </message>
        <message>
            <source>The file that the loop belongs to</source>
            <translation>Die Datei, zu der der Rand gehört</translation>
        </message>
        <message>
            <source>What has been done about it</source>
            <translation>Was damit geschehen ist</translation>
        </message>
        <message>
            <source>#</source>
            <translation>Nr.</translation>
        </message>
        <message>
            <source>Edges</source>
            <translation>Kanten</translation>
        </message>
        <message>
            <source>Diameter</source>
            <translation>Durchm.</translation>
        </message>
        <message>
            <source>Perimeter</source>
            <translation>Umfang</translation>
        </message>
        <message>
            <source>Area</source>
            <translation>Fläche</translation>
        </message>
        <message>
            <source>Planarity</source>
            <translation>Ebenheit</translation>
        </message>
        <message>
            <source>Kind</source>
            <translation>Art</translation>
        </message>
        <message>
            <source>Scan</source>
            <translation>Scan</translation>
        </message>
        <message>
            <source>State</source>
            <translation>Zustand</translation>
        </message>
        <message>
            <source>Number of edges along the boundary</source>
            <translation>Zahl der Kanten am Rand</translation>
        </message>
        <message>
            <source>Largest distance between two boundary vertices, in the scan's unit</source>
            <translation>Größter Abstand zweier Randecken, in der Einheit des Scans</translation>
        </message>
        <message>
            <source>Length of the boundary, in the scan's unit</source>
            <translation>Länge des Randes, in der Einheit des Scans</translation>
        </message>
        <message>
            <source>Area of the boundary's projection to its best plane, in the scan's unit squared</source>
            <translation>Fläche des Randes in seiner besten Ebene, Einheit des Scans zum Quadrat</translation>
        </message>
        <message>
            <source>How far the boundary leaves its best plane: rms distance divided by the diameter</source>
            <translation>Wie weit der Rand von seiner besten Ebene abweicht: mittlerer Abstand durch Durchmesser</translation>
        </message>
        <message>
            <source>Boundary</source>
            <translation>Rand</translation>
        </message>
        <message>
            <source>%1, %2</source>
            <translation>%1, %2</translation>
        </message>
    </context>
    <context>
        <name>loopmend::HolesPanel</name>
        <message>
            <source>Filter: number, kind, state</source>
            <translation>Filter: Nummer, Art, Zustand</translation>
        </message>
        <message>
            <source>Filter</source>
            <translation>Filter</translation>
        </message>
        <message>
            <source>Show only the loops with these words: a number, a kind, a state, a file (Ctrl+L)</source>
            <translation>Nur Ränder mit diesen Wörtern: Nummer, Art, Zustand, Datei (Strg+L)</translation>
        </message>
        <message>
            <source>All loops</source>
            <translation>Alle Ränder</translation>
        </message>
        <message>
            <source>Filled</source>
            <translation>Gefüllt</translation>
        </message>
        <message>
            <source>Accepted</source>
            <translation>Angenommen</translation>
        </message>
        <message>
            <source>Left out</source>
            <translation>Ausgelassen</translation>
        </message>
        <message>
            <source>Group</source>
            <translation>Gruppe</translation>
        </message>
        <message>
            <source>Show only the loops of one group</source>
            <translation>Nur die Ränder einer Gruppe zeigen</translation>
        </message>
        <message>
            <source>Boundary loops</source>
            <translation>Ränder</translation>
        </message>
        <message>
            <source>Every boundary loop; double click or Return flies there</source>
            <translation>Jeder Rand; Doppelklick oder Eingabetaste fliegt hin</translation>
        </message>
        <message>
            <source>No scan is open</source>
            <translation>Kein Scan ist offen</translation>
        </message>
        <message>
            <source>No holes: closed surface</source>
            <translation>Keine Löcher: geschlossene Fläche</translation>
        </message>
        <message>
            <source>&amp;Sort by</source>
            <translation>&amp;Sortieren nach</translation>
        </message>
        <message>
            <source>Select every hole; outer rims, cracks and cuts are left out</source>
            <translation>Jedes Loch auswählen; Ränder, Risse und Schnitte bleiben aus</translation>
        </message>
        <message>
            <source>Problems</source>
            <translation>Probleme</translation>
        </message>
        <message>
            <source>Open loops</source>
            <translation>Offene Ränder</translation>
        </message>
        <message>
            <source>Select all</source>
            <translation>Alle wählen</translation>
        </message>
        <message numerus="yes">
            <source>%Ln hole(s), %L1 open</source>
            <translation>
                <numerusform>%Ln Loch, %L1 offen</numerusform>
                <numerusform>%Ln Löcher, %L1 offen</numerusform>
            </translation>
        </message>
        <message>
            <source>; %L1 left out</source>
            <translation>; %L1 ausgelassen</translation>
        </message>
        <message>
            <source>; %L1 shown</source>
            <translation>; %L1 gezeigt</translation>
        </message>
    </context>
    <context>
        <name>loopmend::InspectPanel</name>
        <message>
            <source>Hole</source>
            <translation>Loch</translation>
        </message>
        <message>
            <source>The hole's number</source>
            <translation>Die Nummer des Lochs</translation>
        </message>
        <message>
            <source>Angle between the normals on both sides, root mean square</source>
            <translation>Winkel zwischen den Normalen beider Seiten, quadratisches Mittel</translation>
        </message>
        <message>
            <source>Angle between the normals on both sides, largest</source>
            <translation>Winkel zwischen den Normalen beider Seiten, größter</translation>
        </message>
        <message>
            <source>Jump of the mean curvature across the seam, root mean square, 1/length</source>
            <translation>Sprung der mittleren Krümmung an der Naht, quadratisches Mittel, 1/Länge</translation>
        </message>
        <message>
            <source>Jump of the mean curvature across the seam, largest, 1/length</source>
            <translation>Sprung der mittleren Krümmung an der Naht, größter, 1/Länge</translation>
        </message>
        <message>
            <source>The rms jump times the hole's diameter: a number without a unit</source>
            <translation>Der mittlere Sprung mal Lochdurchmesser: eine Zahl ohne Einheit</translation>
        </message>
        <message>
            <source>Seams</source>
            <translation>Nähte</translation>
        </message>
        <message>
            <source>How each patch meets the scan, before the flow and now</source>
            <translation>Wie jeder Flicken an den Scan anschließt, vor dem Fluss und jetzt</translation>
        </message>
        <message>
            <source>Copy the table as tab-separated text</source>
            <translation>Die Tabelle als Text mit Tabulatoren kopieren</translation>
        </message>
        <message>
            <source>Seam, before → now</source>
            <translation>Naht, vorher → jetzt</translation>
        </message>
        <message>
            <source>Energy</source>
            <translation>Energie</translation>
        </message>
        <message>
            <source>Section</source>
            <translation>Schnitt</translation>
        </message>
        <message>
            <source>Log</source>
            <translation>Protokoll</translation>
        </message>
        <message>
            <source>Energy and residual against the step</source>
            <translation>Energie und Rest über den Schritten</translation>
        </message>
        <message>
            <source>Mean curvature along a section across the seam</source>
            <translation>Mittlere Krümmung längs eines Schnitts über die Naht</translation>
        </message>
        <message>
            <source>What has happened so far</source>
            <translation>Was bisher geschah</translation>
        </message>
        <message>
            <source>Energy, section, log</source>
            <translation>Energie, Schnitt, Protokoll</translation>
        </message>
        <message>
            <source>What happens is written down here.</source>
            <translation>Hier wird aufgeschrieben, was geschieht.</translation>
        </message>
        <message>
            <source>Copy the whole log</source>
            <translation>Das ganze Protokoll kopieren</translation>
        </message>
        <message>
            <source>Open a scan, fill a hole, and its seam is measured here.</source>
            <translation>Einen Scan öffnen, ein Loch füllen: hier steht dann seine Naht.</translation>
        </message>
        <message>
            <source>The selection is not filled yet.</source>
            <translation>Die Auswahl ist noch nicht gefüllt.</translation>
        </message>
        <message>
            <source>Hole %1: %2</source>
            <translation>Loch %1: %2</translation>
        </message>
        <message>
            <source>Angle rms</source>
            <translation>Winkel rms</translation>
        </message>
        <message>
            <source>Angle max</source>
            <translation>Winkel max</translation>
        </message>
        <message>
            <source>H jump rms</source>
            <translation>H-Spr. rms</translation>
        </message>
        <message>
            <source>H jump max</source>
            <translation>H-Spr. max</translation>
        </message>
        <message>
            <source>H jump · size</source>
            <translation>H-Spr. · Größe</translation>
        </message>
        <message>
            <source>No hole is filled yet. Press Fill and smooth, and the seam is measured here.</source>
            <translation>Noch ist kein Loch gefüllt. Nach dem Füllen steht hier die Naht.</translation>
        </message>
        <message>
            <source>Whose curves</source>
            <translation>Wessen Kurven</translation>
        </message>
        <message>
            <source>The hole whose energy and section are drawn</source>
            <translation>Das Loch, dessen Energie und Schnitt gezeichnet sind</translation>
        </message>
        <message>
            <source>Copy</source>
            <translation>Kopieren</translation>
        </message>
        <message>
            <source>Copy log</source>
            <translation>Protokoll kopieren</translation>
        </message>
    </context>
    <context>
        <name>loopmend::LegendStrip</name>
        <message>
            <source>Legend</source>
            <translation>Legende</translation>
        </message>
        <message>
            <source>The colours of all pictures</source>
            <translation>Die Farben aller Bilder</translation>
        </message>
        <message>
            <source>Mean curvature H</source>
            <translation>Mittlere Krümmung H</translation>
        </message>
        <message>
            <source>Gaussian curv. K</source>
            <translation>Gaußkrümmung K</translation>
        </message>
        <message>
            <source>in 1/length</source>
            <translation>in 1/Länge</translation>
        </message>
        <message>
            <source>in 1/length²</source>
            <translation>in 1/Länge²</translation>
        </message>
        <message>
            <source>hollow</source>
            <translation>hohl</translation>
        </message>
        <message>
            <source>dome or bowl</source>
            <translation>Kuppe, Mulde</translation>
        </message>
        <message>
            <source>bulging</source>
            <translation>gewölbt</translation>
        </message>
        <message>
            <source>saddle</source>
            <translation>Sattel</translation>
        </message>
    </context>
    <context>
        <name>loopmend::LookPanel</name>
        <message>
            <source>Shading</source>
            <translation>Darstellung</translation>
        </message>
        <message>
            <source>Blue, orange</source>
            <translation>Blau, Orange</translation>
        </message>
        <message>
            <source>Purple, green</source>
            <translation>Lila, Grün</translation>
        </message>
        <message>
            <source>Brown, teal</source>
            <translation>Braun, Türkis</translation>
        </message>
        <message>
            <source>Grey</source>
            <translation>Grau</translation>
        </message>
        <message>
            <source>Mean curvature H: a patch that fits continues the scan's colours.</source>
            <translation>Mittlere Krümmung H: ein passender Flicken setzt die Farben des Scans fort.</translation>
        </message>
        <message>
            <source>Gaussian curvature K: domes and bowls against saddles.</source>
            <translation>Gaußsche Krümmung K: Kuppen und Mulden gegen Sättel.</translation>
        </message>
        <message>
            <source>One colour; patches in another, so that they are found.</source>
            <translation>Eine Farbe; Flicken in einer anderen, damit man sie findet.</translation>
        </message>
        <message>
            <source>Reflected stripes: broken where tangents jump, kinked where the curvature jumps.</source>
            <translation>Gespiegelte Streifen: gebrochen, wo Tangenten springen, geknickt, wo die Krümmung springt.</translation>
        </message>
        <message>
            <source>Bands of equal brightness: they stay when you move closer, and kink where tangents jump.</source>
            <translation>Bänder gleicher Helligkeit: sie bleiben beim Näherkommen und knicken, wo Tangenten springen.</translation>
        </message>
        <message>
            <source>Stripes</source>
            <translation>Streifen</translation>
        </message>
        <message>
            <source>How many stripes or bands there are</source>
            <translation>Wie viele Streifen oder Bänder es gibt</translation>
        </message>
        <message>
            <source>Wireframe</source>
            <translation>Drahtgitter</translation>
        </message>
        <message>
            <source>Draw the triangles' edges (W)</source>
            <translation>Die Kanten der Dreiecke zeichnen (W)</translation>
        </message>
        <message>
            <source>Drawn over it</source>
            <translation>Darüber gezeichnet</translation>
        </message>
        <message>
            <source>Colours</source>
            <translation>Farben</translation>
        </message>
        <message>
            <source>Every one of them can be told apart by every kind of colour vision</source>
            <translation>Alle sind für jedes Farbsehen zu unterscheiden</translation>
        </message>
        <message>
            <source>Own range</source>
            <translation>Eigener Bereich</translation>
        </message>
        <message>
            <source>Range</source>
            <translation>Bereich</translation>
        </message>
        <message>
            <source>Percentile</source>
            <translation>Perzentil</translation>
        </message>
        <message>
            <source>This share of the scan's values lies within the range</source>
            <translation>Dieser Anteil der Werte des Scans liegt im Bereich</translation>
        </message>
        <message>
            <source>The curvature at the ends of the colours</source>
            <translation>Die Krümmung an den Enden der Farben</translation>
        </message>
        <message>
            <source>Boundaries and seams</source>
            <translation>Ränder und Nähte</translation>
        </message>
        <message>
            <source>Draw the boundaries of holes and the seams of patches (M)</source>
            <translation>Ränder der Löcher und Nähte der Flicken zeichnen (M)</translation>
        </message>
        <message>
            <source>The scan's own colours or texture. Patches continue the colours smoothly; the grain of a texture is painted on export.</source>
            <translation>Die eigenen Farben oder die Textur des Scans. Flicken setzen die Farben glatt fort; das Korn einer Textur wird beim Exportieren gemalt.</translation>
        </message>
        <message>
            <source>How surfaces are shown (keys 1 to 6)</source>
            <translation>Wie Flächen gezeigt werden (Tasten 1 bis 6)</translation>
        </message>
        <message>
            <source>Scan colours</source>
            <translation>Farben des Scans</translation>
        </message>
        <message>
            <source>Percentile, all scans alike</source>
            <translation>Perzentil, alle Scans gleich</translation>
        </message>
        <message>
            <source>Percentile of each scan</source>
            <translation>Perzentil je Scan</translation>
        </message>
        <message>
            <source>How far the colours reach. The range is symmetric about 0 and comes from the scans alone, so it stays the same while a flow runs. Several scans share the widest range, or each has its own; the legend then shows that of the selected hole's scan</source>
            <translation>Wie weit die Farben reichen. Der Bereich liegt gleich weit um 0 und kommt allein von den Scans; so bleibt er gleich, während ein Fluss läuft. Mehrere Scans teilen den weitesten Bereich, oder jeder hat seinen eigenen; die Legende zeigt dann den des Scans mit dem gewählten Loch</translation>
        </message>
        <message>
            <source>Wireframe: the triangles' edges</source>
            <translation>Drahtgitter: Kanten der Dreiecke</translation>
        </message>
        <message>
            <source>Boundaries and seams as lines</source>
            <translation>Ränder und Nähte als Linien</translation>
        </message>
    </context>
    <context>
        <name>loopmend::MainWindow</name>
        <message>
            <source>Holes</source>
            <translation>Löcher</translation>
        </message>
        <message>
            <source>Patch</source>
            <translation>Flicken</translation>
        </message>
        <message>
            <source>Inspect</source>
            <translation>Prüfen</translation>
        </message>
        <message>
            <source>%1 and %2 more</source>
            <translation>%1 und %2 weitere</translation>
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
            <translation>&amp;Rückgängig: %1</translation>
        </message>
        <message>
            <source>&amp;Undo</source>
            <translation>&amp;Rückgängig</translation>
        </message>
        <message>
            <source>&amp;Redo: %1</source>
            <translation>&amp;Wiederholen: %1</translation>
        </message>
        <message>
            <source>&amp;Redo</source>
            <translation>&amp;Wiederholen</translation>
        </message>
        <message>
            <source>Wrote %1.</source>
            <translation>%1 geschrieben.</translation>
        </message>
        <message>
            <source>Tools</source>
            <translation>Werkzeuge</translation>
        </message>
        <message>
            <source>Display</source>
            <translation>Ansicht</translation>
        </message>
        <message>
            <source>Scene</source>
            <translation>Szene</translation>
        </message>
        <message>
            <source>Stitc&amp;h cracks</source>
            <translation>Risse &amp;vernähen</translation>
        </message>
        <message numerus="yes">
            <source>Stitc&amp;h %Ln crack(s)</source>
            <translation>
                <numerusform>%Ln Riss vernä&amp;hen</numerusform>
                <numerusform>%Ln Risse vernä&amp;hen</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>loopmend::MeasureBox</name>
        <message>
            <source>Copy the distance to the clipboard</source>
            <translation>Den Abstand in die Zwischenablage kopieren</translation>
        </message>
        <message>
            <source>Click two points of a surface: the nearest vertices are taken. Drag beside the surface, or with Shift, to turn the picture. Esc begins anew.</source>
            <translation>Zwei Punkte einer Fläche anklicken: die nächsten Ecken werden genommen. Wer neben der Fläche zieht, oder mit Umschalt, dreht das Bild. Esc beginnt neu.</translation>
        </message>
        <message>
            <source>Distance</source>
            <translation>Abstand</translation>
        </message>
        <message>
            <source>Distance: not known yet</source>
            <translation>Abstand: noch unbekannt</translation>
        </message>
        <message>
            <source>Distance: &lt;b&gt;%1&lt;/b&gt;</source>
            <translation>Abstand: &lt;b&gt;%1&lt;/b&gt;</translation>
        </message>
        <message>
            <source>Along x %1, y %2, z %3</source>
            <translation>Längs x %1, y %2, z %3</translation>
        </message>
        <message>
            <source>%1; in the units of the scan.</source>
            <translation>%1; in der Einheit des Scans.</translation>
        </message>
        <message>
            <source>%1; in %2.</source>
            <translation>%1; in %2.</translation>
        </message>
        <message>
            <source>Copy</source>
            <translation>Kopieren</translation>
        </message>
    </context>
    <context>
        <name>loopmend::MeshView</name>
        <message>
            <source>Mean curvature H</source>
            <translation>Mittlere Krümmung H</translation>
        </message>
        <message>
            <source>Gaussian curvature K</source>
            <translation>Gaußsche Krümmung K</translation>
        </message>
        <message>
            <source>in 1/length</source>
            <translation>in 1/Länge</translation>
        </message>
        <message>
            <source>in 1/length²</source>
            <translation>in 1/Länge²</translation>
        </message>
        <message>
            <source>hollow</source>
            <translation>hohl</translation>
        </message>
        <message>
            <source>dome or bowl</source>
            <translation>Kuppe, Mulde</translation>
        </message>
        <message>
            <source>bulging</source>
            <translation>gewölbt</translation>
        </message>
        <message>
            <source>saddle</source>
            <translation>Sattel</translation>
        </message>
        <message>
            <source>Hole</source>
            <translation>Loch</translation>
        </message>
        <message>
            <source>%1 %2 · %3 edges · %4 across · %5</source>
            <translation>%1 %2 · %3 Kanten · %4 breit · %5</translation>
        </message>
        <message>
            <source>Show everything that was hidden (Ctrl+H). It is filled and exported all the same</source>
            <translation>Alles Ausgeblendete einblenden (Strg+H). Gefüllt und exportiert wird es in jedem Fall</translation>
        </message>
        <message numerus="yes">
            <source>%Ln hidden: show all</source>
            <translation>
                <numerusform>%Ln ausgeblendet: alles einblenden</numerusform>
                <numerusform>%Ln ausgeblendet: alles einblenden</numerusform>
            </translation>
        </message>
        <message>
            <source>in 1/%1</source>
            <translation>in 1/%1</translation>
        </message>
        <message>
            <source>in 1/%1²</source>
            <translation>in 1/%1²</translation>
        </message>
    </context>
    <context>
        <name>loopmend::PictureDialog</name>
        <message>
            <source>Screenshot</source>
            <translation>Bildschirmfoto</translation>
        </message>
        <message>
            <source>Size</source>
            <translation>Größe</translation>
        </message>
        <message>
            <source>How many pixels the picture has</source>
            <translation>Wie viele Pixel das Bild hat</translation>
        </message>
        <message>
            <source>As on the screen</source>
            <translation>Wie auf dem Schirm</translation>
        </message>
        <message>
            <source>Twice as large</source>
            <translation>Doppelt so groß</translation>
        </message>
        <message>
            <source>Four times as large</source>
            <translation>Viermal so groß</translation>
        </message>
        <message>
            <source>Own size</source>
            <translation>Eigene Größe</translation>
        </message>
        <message>
            <source> px</source>
            <translation> px</translation>
        </message>
        <message>
            <source>Width in pixels</source>
            <translation>Breite in Pixeln</translation>
        </message>
        <message>
            <source>Height in pixels</source>
            <translation>Höhe in Pixeln</translation>
        </message>
        <message>
            <source>Ground</source>
            <translation>Grund</translation>
        </message>
        <message>
            <source>What is behind the surface</source>
            <translation>Was hinter der Fläche ist</translation>
        </message>
        <message>
            <source>Transparent</source>
            <translation>Durchsichtig</translation>
        </message>
        <message>
            <source>With</source>
            <translation>Mit</translation>
        </message>
        <message>
            <source>What is drawn beside the surface</source>
            <translation>Was neben der Fläche gezeichnet wird</translation>
        </message>
        <message>
            <source>Legend, axes and scale bar</source>
            <translation>Legende, Achsen und Maßstab</translation>
        </message>
        <message>
            <source>Legend</source>
            <translation>Legende</translation>
        </message>
        <message>
            <source>The surface alone</source>
            <translation>Nur die Fläche</translation>
        </message>
        <message>
            <source>&amp;Save…</source>
            <translation>&amp;Speichern…</translation>
        </message>
        <message>
            <source>Choose a file and write the picture</source>
            <translation>Eine Datei wählen und das Bild schreiben</translation>
        </message>
        <message>
            <source>&amp;Copy</source>
            <translation>&amp;Kopieren</translation>
        </message>
        <message>
            <source>Put the picture into the clipboard</source>
            <translation>Das Bild in die Zwischenablage legen</translation>
        </message>
        <message>
            <source>Si&amp;ze</source>
            <translation>&amp;Größe</translation>
        </message>
        <message>
            <source>&amp;Ground</source>
            <translation>Gr&amp;und</translation>
        </message>
        <message>
            <source>&amp;With</source>
            <translation>&amp;Mit</translation>
        </message>
        <message>
            <source>The graphics cannot draw a picture of this size. Choose a smaller one.</source>
            <translation>Ein Bild dieser Größe kann die Grafik nicht zeichnen. Bitte kleiner wählen.</translation>
        </message>
        <message>
            <source>%1 cannot be written. Choose another folder, or check how much space is left.</source>
            <translation>%1 kann nicht geschrieben werden. Anderen Ordner wählen, oder prüfen, wie viel Platz frei ist.</translation>
        </message>
        <message>
            <source>PNG (*.png)</source>
            <translation>PNG (*.png)</translation>
        </message>
        <message>
            <source>Headings and legend</source>
            <translation>Überschriften und Legende</translation>
        </message>
        <message>
            <source>The surfaces alone</source>
            <translation>Die Flächen allein</translation>
        </message>
    </context>
    <context>
        <name>loopmend::PieceMenu</name>
        <message>
            <source>Move the mouse over the piece, or select one of its holes, and press the key again.</source>
            <translation>Die Maus auf das Stück bewegen oder eines seiner Löcher wählen und die Taste noch einmal drücken.</translation>
        </message>
        <message>
            <source>piece %1 of %2</source>
            <translation>Stück %1 von %2</translation>
        </message>
        <message>
            <source>&amp;Hide %1</source>
            <translation>%1 &amp;ausblenden</translation>
        </message>
        <message>
            <source>It is filled and exported as before</source>
            <translation>Gefüllt und exportiert wird es wie zuvor</translation>
        </message>
        <message>
            <source>&amp;Isolate %1</source>
            <translation>Nur %1 &amp;zeigen</translation>
        </message>
        <message>
            <source>Hide all other pieces</source>
            <translation>Alle anderen Stücke ausblenden</translation>
        </message>
        <message>
            <source>Sho&amp;w all pieces</source>
            <translation>A&amp;lle Stücke einblenden</translation>
        </message>
        <message>
            <source>Show everything that was hidden</source>
            <translation>Alles Ausgeblendete einblenden</translation>
        </message>
        <message numerus="yes">
            <source>%Ln piece(s)</source>
            <translation>
                <numerusform>%Ln Stück</numerusform>
                <numerusform>%Ln Stücke</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>loopmend::PlacePart</name>
        <message>
            <source>Place %1</source>
            <translation>%1 platzieren</translation>
        </message>
    </context>
    <context>
        <name>loopmend::PointsBox</name>
        <message>
            <source>No vertex is picked</source>
            <translation>Keine Ecke ist gewählt</translation>
        </message>
        <message>
            <source>A smooth surface through the vertices of a polyhedron. Open or drop one; its faces are divided, and the flow finds the rest.</source>
            <translation>Eine glatte Fläche durch die Ecken eines Polyeders. Eines öffnen oder hineinziehen; seine Flächen werden geteilt, den Rest findet der Fluss.</translation>
        </message>
        <message>
            <source>Polyhedron</source>
            <translation>Polyeder</translation>
        </message>
        <message>
            <source>Which of the open surfaces is meant</source>
            <translation>Welche der offenen Flächen gemeint ist</translation>
        </message>
        <message>
            <source>All vertices</source>
            <translation>Alle Ecken</translation>
        </message>
        <message>
            <source>The surface runs through every vertex</source>
            <translation>Die Fläche läuft durch jede Ecke</translation>
        </message>
        <message>
            <source>Only those I pick</source>
            <translation>Nur die gewählten</translation>
        </message>
        <message>
            <source>Click vertices in the picture, or draw a box around them; Ctrl takes away</source>
            <translation>Ecken im Bild anklicken oder einen Kasten darum ziehen; Strg nimmt weg</translation>
        </message>
        <message>
            <source>Subdivisions</source>
            <translation>Unterteilungen</translation>
        </message>
        <message>
            <source>Every one makes four triangles of each</source>
            <translation>Jede macht aus jedem Dreieck vier</translation>
        </message>
        <message>
            <source>Open a polyhedron first.</source>
            <translation>Zuerst ein Polyeder öffnen.</translation>
        </message>
        <message>
            <source>At least 4 vertices have to be picked.</source>
            <translation>Mindestens 4 Ecken müssen gewählt sein.</translation>
        </message>
        <message>
            <source>That would be more than 4 million triangles: fewer subdivisions do.</source>
            <translation>Das wären mehr als 4 Millionen Dreiecke: weniger Unterteilungen genügen.</translation>
        </message>
        <message>
            <source>%1 vertices stay</source>
            <translation>%1 Ecken bleiben</translation>
        </message>
        <message>
            <source>%1 triangles</source>
            <translation>%1 Dreiecke</translation>
        </message>
        <message>
            <source>Smooth boundaries</source>
            <translation>Ränder glatt</translation>
        </message>
        <message>
            <source>For a polyhedron with holes: its boundaries become smooth curves through their vertices</source>
            <translation>Für ein Polyeder mit Löchern: seine Ränder werden glatte Kurven durch ihre Ecken</translation>
        </message>
        <message>
            <source>This surface has holes: close them, or let its boundaries become smooth curves.</source>
            <translation>Diese Fläche hat Löcher: sie schließen oder ihre Ränder glatt lassen, wie sie sind.</translation>
        </message>
        <message>
            <source>Clear</source>
            <translation>Leeren</translation>
        </message>
    </context>
    <context>
        <name>loopmend::PreferencesDialog</name>
        <message>
            <source>Preferences</source>
            <translation>Einstellungen</translation>
        </message>
        <message>
            <source>Language</source>
            <translation>Sprache</translation>
        </message>
        <message>
            <source>Counts when the program starts the next time</source>
            <translation>Gilt vom nächsten Start an</translation>
        </message>
        <message>
            <source>As the system has it</source>
            <translation>Wie das System</translation>
        </message>
        <message>
            <source>Colours of the window</source>
            <translation>Farben des Fensters</translation>
        </message>
        <message>
            <source>Light or dark</source>
            <translation>Hell oder dunkel</translation>
        </message>
        <message>
            <source>Light</source>
            <translation>Hell</translation>
        </message>
        <message>
            <source>Dark</source>
            <translation>Dunkel</translation>
        </message>
        <message>
            <source>Colours of curvature</source>
            <translation>Farben der Krümmung</translation>
        </message>
        <message>
            <source>The colours to begin with</source>
            <translation>Die Farben zu Beginn</translation>
        </message>
        <message>
            <source>Memory for undo</source>
            <translation>Speicher fürs Rückgängigmachen</translation>
        </message>
        <message>
            <source>Above this, the oldest changes can no longer be taken back</source>
            <translation>Darüber lassen sich die ältesten Änderungen nicht mehr zurücknehmen</translation>
        </message>
        <message>
            <source>MB</source>
            <translation>MB</translation>
        </message>
        <message>
            <source>Memory for each timeline</source>
            <translation>Speicher je Zeitleiste</translation>
        </message>
        <message>
            <source>Above this, every second recorded state of a patch is forgotten</source>
            <translation>Darüber wird jeder zweite aufgezeichnete Zustand eines Flickens vergessen</translation>
        </message>
        <message>
            <source>Copy for recovery after</source>
            <translation>Sicherungskopie nach</translation>
        </message>
        <message>
            <source>This long after a change, a copy is written that survives a crash</source>
            <translation>So lange nach einer Änderung wird eine Kopie geschrieben, die einen Absturz überlebt</translation>
        </message>
        <message>
            <source>s</source>
            <translation>s</translation>
        </message>
        <message>
            <source>&amp;Language</source>
            <translation>&amp;Sprache</translation>
        </message>
        <message>
            <source>&amp;Window</source>
            <translation>&amp;Fenster</translation>
        </message>
        <message>
            <source>C&amp;urvature</source>
            <translation>K&amp;rümmung</translation>
        </message>
        <message>
            <source>Memory for un&amp;do</source>
            <translation>Speicher für &amp;Rückgängig</translation>
        </message>
        <message>
            <source>Memory for each &amp;timeline</source>
            <translation>Speicher je &amp;Zeitleiste</translation>
        </message>
        <message>
            <source>Copy for &amp;recovery after</source>
            <translation>Sicherungs&amp;kopie nach</translation>
        </message>
        <message>
            <source>Every change counts at once; another language from the next start on.</source>
            <translation>Jede Änderung gilt sofort; eine andere Sprache vom nächsten Start an.</translation>
        </message>
    </context>
    <context>
        <name>loopmend::ProblemBox</name>
        <message>
            <source>Try it, decide</source>
            <translation>Versuchen, entscheiden</translation>
        </message>
        <message>
            <source>Which flow works on it</source>
            <translation>Welcher Fluss daran arbeitet</translation>
        </message>
        <message>
            <source>Show the start, before any flow</source>
            <translation>Den Anfang zeigen, vor jedem Fluss</translation>
        </message>
        <message>
            <source>Let the flow work on it until it converges</source>
            <translation>Den Fluss daran arbeiten lassen, bis er konvergiert</translation>
        </message>
        <message>
            <source>Several flows from this start, side by side, in a window of their own</source>
            <translation>Mehrere Flüsse von diesem Anfang, nebeneinander in einem eigenen Fenster</translation>
        </message>
        <message>
            <source>Stop at once; the start is shown again (Esc)</source>
            <translation>Sofort anhalten; der Anfang wird wieder gezeigt (Esc)</translation>
        </message>
        <message>
            <source>The result comes into the document; can be undone</source>
            <translation>Das Ergebnis kommt ins Dokument; lässt sich rückgängig machen</translation>
        </message>
        <message>
            <source>Give it up; the document is as it was</source>
            <translation>Aufgeben; das Dokument ist, wie es war</translation>
        </message>
        <message>
            <source>Copy the commands that do the same</source>
            <translation>Die Befehle kopieren, die dasselbe tun</translation>
        </message>
        <message>
            <source>Boundary</source>
            <translation>Rand</translation>
        </message>
        <message>
            <source>Continuity</source>
            <translation>Übergang</translation>
        </message>
        <message>
            <source>Preview</source>
            <translation>Vorschau</translation>
        </message>
        <message>
            <source>Evolve</source>
            <translation>Entwickeln</translation>
        </message>
        <message>
            <source>Compare flows…</source>
            <translation>Flüsse vergleichen…</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Abbrechen</translation>
        </message>
        <message>
            <source>Accept</source>
            <translation>Annehmen</translation>
        </message>
        <message>
            <source>Discard</source>
            <translation>Verwerfen</translation>
        </message>
        <message>
            <source>Copy command line</source>
            <translation>Befehlszeile kopieren</translation>
        </message>
    </context>
    <context>
        <name>loopmend::ProblemController</name>
        <message>
            <source>Making the start…</source>
            <translation>Anfang wird gemacht…</translation>
        </message>
        <message>
            <source>%1 free vertices.</source>
            <translation>%1 freie Ecken.</translation>
        </message>
        <message>
            <source>%1 at work…</source>
            <translation>%1 arbeitet…</translation>
        </message>
        <message>
            <source>Step %1, energy %2, %3 vertices</source>
            <translation>Schritt %1, Energie %2, %3 Ecken</translation>
        </message>
        <message>
            <source>Converged after %1 steps, energy %2 → %3.</source>
            <translation>Konvergiert nach %1 Schritten, Energie %2 → %3.</translation>
        </message>
        <message>
            <source>%1 steps, energy %2 → %3.</source>
            <translation>%1 Schritte, Energie %2 → %3.</translation>
        </message>
        <message>
            <source>Cancelled.</source>
            <translation>Abgebrochen.</translation>
        </message>
        <message>
            <source>The main window is busy, or has gone on to something else.</source>
            <translation>Das Hauptfenster ist beschäftigt oder schon bei etwas anderem.</translation>
        </message>
        <message>
            <source>Taking over…</source>
            <translation>Wird übernommen…</translation>
        </message>
        <message>
            <source>%1: applied. Ctrl+Z undoes it.</source>
            <translation>%1: übernommen. Strg+Z nimmt es zurück.</translation>
        </message>
        <message>
            <source>%1 was applied in the main window; Ctrl+Z there undoes it.</source>
            <translation>%1 wurde ins Hauptfenster übernommen; Strg+Z dort nimmt es zurück.</translation>
        </message>
    </context>
    <context>
        <name>loopmend::ProgressBox</name>
        <message>
            <source>Nothing is running.</source>
            <translation>Nichts läuft.</translation>
        </message>
        <message>
            <source>Progress</source>
            <translation>Fortschritt</translation>
        </message>
        <message>
            <source>How far the present job is</source>
            <translation>Wie weit die jetzige Arbeit ist</translation>
        </message>
        <message>
            <source>Stop at once; what was accepted so far is kept (Esc)</source>
            <translation>Sofort anhalten; das Erreichte bleibt (Esc)</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Abbrechen</translation>
        </message>
    </context>
    <context>
        <name>loopmend::RegionBox</name>
        <message>
            <source>Paint the region with the left button</source>
            <translation>Das Gebiet mit der linken Taste malen</translation>
        </message>
        <message>
            <source>Draw an outline around the region</source>
            <translation>Einen Umriss um das Gebiet ziehen</translation>
        </message>
        <message>
            <source>What is painted joins the region; Ctrl takes away</source>
            <translation>Gemaltes kommt zum Gebiet; Strg nimmt weg</translation>
        </message>
        <message>
            <source>What is painted leaves the region; Ctrl adds</source>
            <translation>Gemaltes verlässt das Gebiet; Strg nimmt dazu</translation>
        </message>
        <message>
            <source>Width of the brush</source>
            <translation>Breite des Pinsels</translation>
        </message>
        <message>
            <source>One ring of triangles more</source>
            <translation>Ein Ring Dreiecke mehr</translation>
        </message>
        <message>
            <source>One ring of triangles less</source>
            <translation>Ein Ring Dreiecke weniger</translation>
        </message>
        <message>
            <source>Begin the region anew</source>
            <translation>Das Gebiet neu beginnen</translation>
        </message>
        <message>
            <source>How wide the brush is on the screen</source>
            <translation>Wie breit der Pinsel auf dem Bildschirm ist</translation>
        </message>
        <message>
            <source>Also what is hidden</source>
            <translation>Auch Verdecktes</translation>
        </message>
        <message>
            <source>The lasso takes what lies behind the surface as well</source>
            <translation>Das Lasso nimmt auch, was hinter der Fläche liegt</translation>
        </message>
        <message>
            <source>%1 vertices</source>
            <translation>%1 Ecken</translation>
        </message>
        <message>
            <source>Nothing is painted yet.</source>
            <translation>Noch ist nichts gemalt.</translation>
        </message>
        <message>
            <source>Take the painted faces away, as at a ragged boundary; Ctrl+Z brings them back</source>
            <translation>Die bemalten Flächen wegnehmen, etwa an einem ausgefransten Rand; Strg+Z holt sie zurück</translation>
        </message>
        <message>
            <source>Take the painted faces away, a spike or a bump, and fill and smooth the hole that this makes; one Ctrl+Z brings them back</source>
            <translation>Die bemalten Flächen wegnehmen, eine Spitze oder Beule, und das entstandene Loch füllen und glätten; ein Strg+Z holt sie zurück</translation>
        </message>
        <message>
            <source>Paint what shall become smooth, or be erased; everything else is held. Drag beside the surface, or with Shift, to turn the picture.</source>
            <translation>Bemalen, was glatt werden oder gelöscht werden soll; alles andere wird festgehalten. Neben der Fläche ziehen oder mit Umschalt, um das Bild zu drehen.</translation>
        </message>
        <message>
            <source>Brush</source>
            <translation>Pinsel</translation>
        </message>
        <message>
            <source>Lasso</source>
            <translation>Lasso</translation>
        </message>
        <message>
            <source>Add</source>
            <translation>Dazu</translation>
        </message>
        <message>
            <source>Take away</source>
            <translation>Weg</translation>
        </message>
        <message>
            <source>Grow</source>
            <translation>Wachsen</translation>
        </message>
        <message>
            <source>Shrink</source>
            <translation>Schrumpfen</translation>
        </message>
        <message>
            <source>Clear</source>
            <translation>Leeren</translation>
        </message>
        <message>
            <source>Erase</source>
            <translation>Löschen</translation>
        </message>
        <message>
            <source>Erase and fill</source>
            <translation>Löschen und füllen</translation>
        </message>
    </context>
    <context>
        <name>loopmend::RepairDialog</name>
        <message>
            <source>Vertices at exactly the same place</source>
            <translation>Ecken an genau derselben Stelle</translation>
        </message>
        <message>
            <source>Join</source>
            <translation>Verbinden</translation>
        </message>
        <message>
            <source>Faces share one vertex there; the scan hangs together along it</source>
            <translation>Flächen teilen dort eine Ecke; der Scan hängt dort zusammen</translation>
        </message>
        <message>
            <source>Degenerate faces</source>
            <translation>Entartete Flächen</translation>
        </message>
        <message>
            <source>Remove</source>
            <translation>Entfernen</translation>
        </message>
        <message>
            <source>Faces that have a vertex twice, and so no area</source>
            <translation>Flächen, die eine Ecke zweimal haben und so keinen Inhalt</translation>
        </message>
        <message>
            <source>Duplicate faces</source>
            <translation>Doppelte Flächen</translation>
        </message>
        <message>
            <source>Faces over the same three vertices: one stays, or none where they cancel out</source>
            <translation>Flächen über denselben drei Ecken: eine bleibt, oder keine, wo sie sich aufheben</translation>
        </message>
        <message>
            <source>Faces that intersect others</source>
            <translation>Flächen, die andere schneiden</translation>
        </message>
        <message>
            <source>Cut out</source>
            <translation>Ausschneiden</translation>
        </message>
        <message>
            <source>They are removed; the holes that this leaves can be filled</source>
            <translation>Sie werden entfernt; die Löcher, die bleiben, können gefüllt werden</translation>
        </message>
        <message>
            <source>Non-manifold edges and vertices, faces turned the wrong way</source>
            <translation>Nicht-mannigfaltige Kanten und Ecken, verkehrt liegende Flächen</translation>
        </message>
        <message>
            <source>Separate</source>
            <translation>Trennen</translation>
        </message>
        <message>
            <source>Every edge gets two faces at most, every vertex one fan; faces are turned to agree</source>
            <translation>Jede Kante bekommt höchstens zwei Flächen, jede Ecke einen Fächer; Flächen werden einheitlich gewendet</translation>
        </message>
        <message>
            <source>Tiny loose pieces</source>
            <translation>Winzige lose Stücke</translation>
        </message>
        <message>
            <source>Pieces of up to ten faces and a twentieth of the extent of the largest piece</source>
            <translation>Stücke mit bis zu zehn Flächen und einem Zwanzigstel der Ausdehnung des größten Stücks</translation>
        </message>
        <message>
            <source>Repair</source>
            <translation>Reparieren</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>&amp;Fix all</source>
            <translation>&amp;Alles beheben</translation>
        </message>
        <message>
            <source>Looking for defects…</source>
            <translation>Fehler werden gesucht…</translation>
        </message>
        <message>
            <source>none</source>
            <translation>keine</translation>
        </message>
        <message>
            <source>Every change can be undone. Patches of a scan go when it is repaired.</source>
            <translation>Jede Änderung kann zurückgenommen werden. Die Flicken eines Scans gehen, wenn er repariert wird.</translation>
        </message>
        <message>
            <source>None of these is left.</source>
            <translation>Nichts davon ist übrig.</translation>
        </message>
        <message>
            <source>Tiny handles; Fix all leaves them</source>
            <translation>Winzige Henkel; „Alles beheben“ lässt sie stehen</translation>
        </message>
        <message>
            <source>Cut open</source>
            <translation>Aufschneiden</translation>
        </message>
        <message>
            <source>Struts and tunnels of at most eight edges around: most come from noise, some may be real. Holes are left of each, to be filled</source>
            <translation>Streben und Tunnel mit höchstens acht Kanten Umfang: die meisten kommen vom Rauschen, manche mögen echt sein. Von jedem bleiben Löcher, die gefüllt werden können</translation>
        </message>
        <message>
            <source>Mend everything that was found but the tiny handles, in this order</source>
            <translation>Alles Gefundene außer den winzigen Henkeln beheben, in dieser Reihenfolge</translation>
        </message>
    </context>
    <context>
        <name>loopmend::ScanCommands</name>
        <message>
            <source>%1 took several runs, or was stopped halfway through one; the command repeats the last run only.</source>
            <translation>%1: mehrere Läufe, oder mitten in einem angehalten; der Befehl wiederholt nur den letzten Lauf.</translation>
        </message>
        <message>
            <source>%1: the patch cuts the surface; the command would leave it open.</source>
            <translation>%1: der Flicken schneidet die Fläche; der Befehl ließe das Loch offen.</translation>
        </message>
        <message>
            <source>%1 was made in the window: export it as surface.ply, without patches, before you use the command.</source>
            <translation>%1 ist im Fenster entstanden: vor dem Befehl als surface.ply exportieren, ohne Flicken.</translation>
        </message>
    </context>
    <context>
        <name>loopmend::ScenePanel</name>
        <message>
            <source>Hide everything but the chosen row (Shift+H)</source>
            <translation>Alles außer der gewählten Zeile ausblenden (Umschalt+H)</translation>
        </message>
        <message>
            <source>Show everything that was hidden (Ctrl+H)</source>
            <translation>Alles Ausgeblendete einblenden (Strg+H)</translation>
        </message>
        <message>
            <source>Scene</source>
            <translation>Szene</translation>
        </message>
        <message>
            <source>Scans, their pieces and patches; the check boxes hide and show them</source>
            <translation>Scans, ihre Stücke und Flicken; die Kästchen blenden sie aus und ein</translation>
        </message>
        <message>
            <source>Shown</source>
            <translation>Gezeigt</translation>
        </message>
        <message>
            <source>Triangles</source>
            <translation>Dreiecke</translation>
        </message>
        <message>
            <source>Hiding changes the picture alone: what is hidden is filled, checked and exported as before.</source>
            <translation>Ausblenden ändert nur das Bild: Ausgeblendetes wird gefüllt, geprüft und exportiert wie zuvor.</translation>
        </message>
        <message>
            <source>Piece %1, %2 across</source>
            <translation>Stück %1, Größe %2</translation>
        </message>
        <message>
            <source>Lengths in</source>
            <translation>Längen in</translation>
        </message>
        <message>
            <source>What the lengths of the scans are measured in. Nothing is converted; it is shown, and written to 3MF</source>
            <translation>Worin die Längen der Scans gemessen sind. Umgerechnet wird nichts; es wird gezeigt und in 3MF geschrieben</translation>
        </message>
        <message>
            <source>Isolate</source>
            <translation>Nur dies</translation>
        </message>
        <message>
            <source>Show all</source>
            <translation>Alles einblenden</translation>
        </message>
        <message numerus="yes">
            <source>%Ln smaller piece(s)</source>
            <translation>
                <numerusform>%Ln kleineres Stück</numerusform>
                <numerusform>%Ln kleinere Stücke</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln patch(es)</source>
            <translation>
                <numerusform>%Ln Flicken</numerusform>
                <numerusform>%Ln Flicken</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>loopmend::SectionView</name>
        <message>
            <source>±σ</source>
            <translation>±σ</translation>
        </message>
        <message>
            <source>Mean curvature along a section across the seam</source>
            <translation>Mittlere Krümmung längs eines Schnitts über die Naht</translation>
        </message>
        <message>
            <source>Direction of the section</source>
            <translation>Richtung des Schnitts</translation>
        </message>
        <message>
            <source>Turns the section about the hole's axis; 0° runs along the hole's longest direction</source>
            <translation>Dreht den Schnitt um die Achse des Lochs; 0° liegt in seiner längsten Richtung</translation>
        </message>
        <message>
            <source>%1°</source>
            <translation>%1°</translation>
        </message>
        <message>
            <source>Fill a hole, and H across its seam is drawn here.</source>
            <translation>Ein Loch füllen: hier steht dann H quer zur Naht.</translation>
        </message>
        <message>
            <source>H of scan</source>
            <translation>H des Scans</translation>
        </message>
        <message>
            <source>patch</source>
            <translation>Flicken</translation>
        </message>
        <message>
            <source>initial patch</source>
            <translation>erste Fläche</translation>
        </message>
    </context>
    <context>
        <name>loopmend::SessionDialog</name>
        <message>
            <source>Save session</source>
            <translation>Sitzung speichern</translation>
        </message>
        <message>
            <source>&amp;Keep the scans in the session</source>
            <translation>&amp;Die Scans in der Sitzung behalten</translation>
        </message>
        <message>
            <source>Loopmend session (*.loopmend)</source>
            <translation>Loopmend-Sitzung (*.loopmend)</translation>
        </message>
        <message>
            <source>Keep the scans in the session</source>
            <translation>Die Scans in der Sitzung behalten</translation>
        </message>
        <message>
            <source>The session can be moved or sent by itself, and is as large as the compressed scans. Pictures and material files beside a scan are not in it</source>
            <translation>Die Sitzung lässt sich allein verschieben oder verschicken und ist so groß wie die komprimierten Scans. Bilder und Materialdateien neben einem Scan sind nicht darin</translation>
        </message>
    </context>
    <context>
        <name>loopmend::ShortcutSheet</name>
        <message>
            <source> or </source>
            <translation> oder </translation>
        </message>
        <message>
            <source>Keyboard shortcuts</source>
            <translation>Tastenkürzel</translation>
        </message>
        <message>
            <source>Mouse and keys in the picture</source>
            <translation>Maus und Tasten im Bild</translation>
        </message>
        <message>
            <source>Drag</source>
            <translation>Ziehen</translation>
        </message>
        <message>
            <source>Turn</source>
            <translation>Drehen</translation>
        </message>
        <message>
            <source>Shift+drag, middle button</source>
            <translation>Umschalt+Ziehen, mittlere Taste</translation>
        </message>
        <message>
            <source>Move sideways</source>
            <translation>Seitlich bewegen</translation>
        </message>
        <message>
            <source>Wheel, right button, +, −</source>
            <translation>Rad, rechte Taste, +, −</translation>
        </message>
        <message>
            <source>Closer, further away</source>
            <translation>Näher, weiter weg</translation>
        </message>
        <message>
            <source>Arrow keys</source>
            <translation>Pfeiltasten</translation>
        </message>
        <message>
            <source>Turn by ten degrees</source>
            <translation>Um zehn Grad drehen</translation>
        </message>
        <message>
            <source>Select; with Ctrl, add</source>
            <translation>Auswählen; mit Strg dazu</translation>
        </message>
        <message>
            <source>Fly there</source>
            <translation>Hinfliegen</translation>
        </message>
        <message>
            <source>Click on a surface</source>
            <translation>Klick auf eine Fläche</translation>
        </message>
        <message>
            <source>Show the values at this point</source>
            <translation>Die Werte an dieser Stelle zeigen</translation>
        </message>
        <message>
            <source>Tab</source>
            <translation>Tabulator</translation>
        </message>
        <message>
            <source>From control to control</source>
            <translation>Von Bedienteil zu Bedienteil</translation>
        </message>
        <message>
            <source>Return in the table</source>
            <translation>Eingabetaste in der Tabelle</translation>
        </message>
        <message>
            <source>Fly to the hole</source>
            <translation>Zum Loch fliegen</translation>
        </message>
        <message>
            <source>Shift+arrow keys</source>
            <translation>Umschalt+Pfeiltasten</translation>
        </message>
        <message>
            <source>Menu key in the table</source>
            <translation>Menütaste in der Tabelle</translation>
        </message>
        <message>
            <source>Sort, choose columns</source>
            <translation>Sortieren, Spalten wählen</translation>
        </message>
        <message>
            <source>Click on a boundary</source>
            <translation>Klick auf einen Rand</translation>
        </message>
        <message>
            <source>Double click on a boundary or row</source>
            <translation>Doppelklick auf Rand oder Zeile</translation>
        </message>
    </context>
    <context>
        <name>loopmend::SmallHolesBox</name>
        <message>
            <source>Largest size</source>
            <translation>Größte Größe</translation>
        </message>
        <message>
            <source>Holes up to this size are meant</source>
            <translation>Löcher bis zu dieser Größe sind gemeint</translation>
        </message>
        <message>
            <source>edges</source>
            <translation>Kanten</translation>
        </message>
        <message>
            <source>diameter</source>
            <translation>Durchmesser</translation>
        </message>
        <message>
            <source>Measure</source>
            <translation>Maß</translation>
        </message>
        <message>
            <source>Fill</source>
            <translation>Füllen</translation>
        </message>
        <message>
            <source>Fill every open hole up to this size</source>
            <translation>Jedes offene Loch bis zu dieser Größe füllen</translation>
        </message>
        <message>
            <source>Include outer rims</source>
            <translation>Außenränder einschließen</translation>
        </message>
        <message>
            <source>What the size of a hole is: edges along its boundary, or its diameter in the scan's unit</source>
            <translation>Was die Größe eines Lochs ist: Kanten am Rand, oder Durchmesser in der Einheit des Scans</translation>
        </message>
        <message>
            <source>The outline of an open sheet looks like a hole to a program. It is left out unless you include it here, or select it yourself</source>
            <translation>Der Rand einer offenen Fläche sieht für ein Programm wie ein Loch aus. Er bleibt aus, wenn Sie ihn nicht hier einschließen oder selbst auswählen</translation>
        </message>
        <message>
            <source>Fill all up to</source>
            <translation>Alle füllen bis</translation>
        </message>
        <message>
            <source>Include outer rims of open sheets (none here)</source>
            <translation>Außenränder einschließen (hier keine)</translation>
        </message>
        <message>
            <source>Fill %L1 of %L2</source>
            <translation>%L1 von %L2 füllen</translation>
        </message>
        <message>
            <source>Include outer rims of open sheets (%L1)</source>
            <translation>Außenränder einschließen (%L1)</translation>
        </message>
    </context>
    <context>
        <name>loopmend::StatusLine</name>
        <message>
            <source>Ready</source>
            <translation>Bereit</translation>
        </message>
        <message>
            <source>%1 triangles · %2 vertices</source>
            <translation>%1 Dreiecke · %2 Ecken</translation>
        </message>
        <message>
            <source> · residual %1</source>
            <translation> · Rest %1</translation>
        </message>
        <message>
            <source> · σ %1 · τ %2</source>
            <translation> · σ %1 · τ %2</translation>
        </message>
        <message>
            <source> · %1 s</source>
            <translation> · %1 s</translation>
        </message>
        <message>
            <source>Intersections have not been looked for yet</source>
            <translation>Überschneidungen wurden noch nicht gesucht</translation>
        </message>
        <message>
            <source>No open boundary loops</source>
            <translation>Keine offenen Randschleifen</translation>
        </message>
        <message>
            <source>step %1</source>
            <translation>Schritt %1</translation>
        </message>
        <message>
            <source> · J %1</source>
            <translation> · J %1</translation>
        </message>
        <message>
            <source> · energy %1</source>
            <translation> · Energie %1</translation>
        </message>
        <message numerus="yes">
            <source>Watertight but for %Ln crack(s): press Stitch</source>
            <translation>
                <numerusform>Wasserdicht bis auf %Ln Riss: Vernähen drücken</numerusform>
                <numerusform>Wasserdicht bis auf %Ln Risse: Vernähen drücken</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>Not watertight: %Ln open boundary loop(s)</source>
            <translation>
                <numerusform>Nicht wasserdicht: %Ln offener Rand</numerusform>
                <numerusform>Nicht wasserdicht: %Ln offene Ränder</numerusform>
            </translation>
        </message>
        <message>
            <source>Not checked yet</source>
            <translation>Noch nicht geprüft</translation>
        </message>
    </context>
    <context>
        <name>loopmend::TaskRunner</name>
        <message>
            <source>The system allows no further thread for this work (ulimit -u). Close other programs, or raise that limit.</source>
            <translation>Das System erlaubt keinen weiteren Thread für diese Arbeit (ulimit -u). Andere Programme schließen oder diese Grenze erhöhen.</translation>
        </message>
    </context>
    <context>
        <name>loopmend::ToolController</name>
        <message>
            <source>Paint a region first.</source>
            <translation>Zuerst ein Gebiet malen.</translation>
        </message>
        <message>
            <source>Region of %1</source>
            <translation>Gebiet von %1</translation>
        </message>
        <message>
            <source>Surface through the points of %1</source>
            <translation>Fläche durch die Punkte von %1</translation>
        </message>
        <message>
            <source>Blend of %1</source>
            <translation>Verbindung von %1</translation>
        </message>
    </context>
    <context>
        <name>loopmend::ToolsPanel</name>
        <message>
            <source>Region</source>
            <translation>Gebiet</translation>
        </message>
        <message>
            <source>Points</source>
            <translation>Punkte</translation>
        </message>
        <message>
            <source>A smooth surface through the vertices of a polyhedron (I)</source>
            <translation>Eine glatte Fläche durch die Ecken eines Polyeders (I)</translation>
        </message>
        <message>
            <source>Blend</source>
            <translation>Verbinden</translation>
        </message>
        <message>
            <source>Surface through points</source>
            <translation>Fläche durch Punkte</translation>
        </message>
        <message>
            <source>Bridge</source>
            <translation>Brücke</translation>
        </message>
        <message>
            <source>Part a hole into two by a strip between two of its vertices (G)</source>
            <translation>Ein Loch durch einen Streifen zwischen zweien seiner Ecken in zwei teilen (G)</translation>
        </message>
        <message>
            <source>Join two or more boundaries by one patch (B)</source>
            <translation>Zwei oder mehr Ränder durch einen Flicken verbinden (B)</translation>
        </message>
        <message>
            <source>Join boundaries</source>
            <translation>Ränder verbinden</translation>
        </message>
        <message>
            <source>Distance</source>
            <translation>Abstand</translation>
        </message>
        <message>
            <source>The distance between two vertices (D)</source>
            <translation>Der Abstand zweier Ecken (D)</translation>
        </message>
        <message>
            <source>Fill part</source>
            <translation>Teil füllen</translation>
        </message>
        <message>
            <source>Fill a part of a hole, between two of its vertices (Shift+G)</source>
            <translation>Einen Teil eines Lochs füllen, zwischen zwei seiner Ecken (Umschalt+G)</translation>
        </message>
        <message>
            <source>Choose a tool. Region makes a part of a surface smooth; Points finds a surface through the vertices of a polyhedron; Blend joins boundaries of one or several parts; Bridge parts a hole into two; Fill part closes a hole between two of its vertices; Distance measures between two vertices.</source>
            <translation>Ein Werkzeug wählen. Gebiet glättet einen Teil einer Fläche; Punkte findet eine Fläche durch die Ecken eines Polyeders; Verbinden fügt Ränder eines oder mehrerer Teile zusammen; Brücke teilt ein Loch in zwei; Teil füllen schließt ein Loch zwischen zwei seiner Ecken; Abstand misst zwischen zwei Ecken.</translation>
        </message>
        <message>
            <source>Click two vertices of a boundary. A strip of surface is laid between them, at once; Ctrl+Z takes it back. On one loop it makes two simpler holes. Between two loops it joins them into one.</source>
            <translation>Klicken Sie zwei Ecken eines Randes an. Sofort wird ein Flächenstreifen zwischen sie gelegt; Strg+Z nimmt ihn zurück. Auf einem Rand macht er zwei einfachere Löcher. Zwischen zwei Rändern macht er einen daraus.</translation>
        </message>
        <message>
            <source>Click two vertices of one hole. A bridge is laid between them, and the marked part of the hole is filled and smoothed: the shorter one, or with Ctrl the longer one. One Ctrl+Z takes all of it back.</source>
            <translation>Klicken Sie zwei Ecken eines Lochs an. Zwischen sie wird eine Brücke gelegt, und der markierte Teil des Lochs wird gefüllt und geglättet: der kürzere, mit Strg der längere. Ein Strg+Z nimmt alles zurück.</translation>
        </message>
        <message>
            <source>Fill a part of a hole</source>
            <translation>Einen Teil eines Lochs füllen</translation>
        </message>
        <message>
            <source>Make a region of a surface smooth, its neighborhood held (R)</source>
            <translation>Ein Gebiet einer Fläche glätten, die Umgebung gehalten (R)</translation>
        </message>
    </context>
    <context>
        <name>loopmend::Welcome</name>
        <message>
            <source>Open a scan, or drop one here</source>
            <translation>Einen Scan öffnen oder hier ablegen</translation>
        </message>
        <message>
            <source>PLY, STL, OBJ, OFF, glTF or 3MF; or a saved session</source>
            <translation>PLY, STL, OBJ, OFF, glTF oder 3MF; oder eine gespeicherte Sitzung</translation>
        </message>
        <message>
            <source>Choose a file (Ctrl+O)</source>
            <translation>Eine Datei wählen (Strg+O)</translation>
        </message>
        <message>
            <source>A small made-up scan with five holes</source>
            <translation>Ein kleiner gemachter Scan mit fünf Löchern</translation>
        </message>
        <message>
            <source>Opened lately</source>
            <translation>Zuletzt geöffnet</translation>
        </message>
        <message>
            <source>Open %1</source>
            <translation>%1 öffnen</translation>
        </message>
        <message>
            <source>Examples of the paper</source>
            <translation>Beispiele des Aufsatzes</translation>
        </message>
        <message>
            <source>Open…</source>
            <translation>Öffnen…</translation>
        </message>
        <message>
            <source>Try the sample</source>
            <translation>Beispiel ansehen</translation>
        </message>
    </context>
    <context>
        <name>loopmend::WindowActions</name>
        <message>
            <source>%1 (%2)</source>
            <translation>%1 (%2)</translation>
        </message>
        <message>
            <source>&amp;File</source>
            <translation>&amp;Datei</translation>
        </message>
        <message>
            <source>Open &amp;recent</source>
            <translation>&amp;Zuletzt geöffnet</translation>
        </message>
        <message>
            <source>C&amp;lose</source>
            <translation>Sch&amp;ließen</translation>
        </message>
        <message>
            <source>&amp;Edit</source>
            <translation>&amp;Bearbeiten</translation>
        </message>
        <message>
            <source>&amp;View</source>
            <translation>&amp;Ansicht</translation>
        </message>
        <message>
            <source>&amp;Patch</source>
            <translation>&amp;Flicken</translation>
        </message>
        <message>
            <source>&amp;Help</source>
            <translation>&amp;Hilfe</translation>
        </message>
        <message>
            <source>Tools</source>
            <translation>Werkzeuge</translation>
        </message>
        <message>
            <source>Open</source>
            <translation>Öffnen</translation>
        </message>
        <message>
            <source>Save</source>
            <translation>Speichern</translation>
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
            <source>&amp;Open…</source>
            <translation>&amp;Öffnen…</translation>
        </message>
        <message>
            <source>Open a scan or a session</source>
            <translation>Einen Scan oder eine Sitzung öffnen</translation>
        </message>
        <message>
            <source>&amp;Add to the scene…</source>
            <translation>Zur Szene &amp;hinzufügen…</translation>
        </message>
        <message>
            <source>Open further scans beside the present ones</source>
            <translation>Weitere Scans neben den jetzigen öffnen</translation>
        </message>
        <message>
            <source>Open the sa&amp;mple</source>
            <translation>Das &amp;Beispiel öffnen</translation>
        </message>
        <message>
            <source>Open a small made-up scan with five holes</source>
            <translation>Einen kleinen gemachten Scan mit fünf Löchern öffnen</translation>
        </message>
        <message>
            <source>&amp;Save session</source>
            <translation>Sitzung &amp;speichern</translation>
        </message>
        <message>
            <source>Keep scans and patches as they are, to go on another day</source>
            <translation>Scans und Flicken behalten, wie sie sind, um später weiterzumachen</translation>
        </message>
        <message>
            <source>Save session &amp;as…</source>
            <translation>Sitzung speichern &amp;als…</translation>
        </message>
        <message>
            <source>Save the session under another name</source>
            <translation>Die Sitzung unter anderem Namen speichern</translation>
        </message>
        <message>
            <source>&amp;Export…</source>
            <translation>&amp;Exportieren…</translation>
        </message>
        <message>
            <source>Write scan and patches to a mesh file</source>
            <translation>Scan und Flicken in eine Netzdatei schreiben</translation>
        </message>
        <message>
            <source>S&amp;creenshot…</source>
            <translation>Bildschirm&amp;foto…</translation>
        </message>
        <message>
            <source>Write the picture to a PNG file</source>
            <translation>Das Bild in eine PNG-Datei schreiben</translation>
        </message>
        <message>
            <source>&amp;Quit</source>
            <translation>Be&amp;enden</translation>
        </message>
        <message>
            <source>Close the window</source>
            <translation>Das Fenster schließen</translation>
        </message>
        <message>
            <source>&amp;Undo</source>
            <translation>&amp;Rückgängig</translation>
        </message>
        <message>
            <source>Take back the last change</source>
            <translation>Die letzte Änderung zurücknehmen</translation>
        </message>
        <message>
            <source>&amp;Redo</source>
            <translation>&amp;Wiederholen</translation>
        </message>
        <message>
            <source>Do it again</source>
            <translation>Noch einmal tun</translation>
        </message>
        <message>
            <source>Select &amp;all holes</source>
            <translation>&amp;Alle Löcher wählen</translation>
        </message>
        <message>
            <source>Select every hole</source>
            <translation>Jedes Loch auswählen</translation>
        </message>
        <message>
            <source>&amp;Next hole</source>
            <translation>&amp;Nächstes Loch</translation>
        </message>
        <message>
            <source>Select the next hole of the table and fly there</source>
            <translation>Das nächste Loch der Tabelle wählen und hinfliegen</translation>
        </message>
        <message>
            <source>&amp;Previous hole</source>
            <translation>&amp;Voriges Loch</translation>
        </message>
        <message>
            <source>Select the hole before and fly there</source>
            <translation>Das vorige Loch wählen und hinfliegen</translation>
        </message>
        <message>
            <source>&amp;Filter holes</source>
            <translation>Löcher &amp;filtern</translation>
        </message>
        <message>
            <source>Write into the filter of the holes table</source>
            <translation>In den Filter der Tabelle schreiben</translation>
        </message>
        <message>
            <source>Pre&amp;ferences…</source>
            <translation>&amp;Einstellungen…</translation>
        </message>
        <message>
            <source>Language, colours, memory, recovery</source>
            <translation>Sprache, Farben, Speicher, Wiederherstellung</translation>
        </message>
        <message>
            <source>&amp;Mean curvature</source>
            <translation>&amp;Mittlere Krümmung</translation>
        </message>
        <message>
            <source>Colour by mean curvature H</source>
            <translation>Nach mittlerer Krümmung H färben</translation>
        </message>
        <message>
            <source>&amp;Gaussian curvature</source>
            <translation>&amp;Gaußsche Krümmung</translation>
        </message>
        <message>
            <source>Colour by Gaussian curvature K</source>
            <translation>Nach Gaußscher Krümmung K färben</translation>
        </message>
        <message>
            <source>&amp;Plain</source>
            <translation>&amp;Schlicht</translation>
        </message>
        <message>
            <source>One colour; patches in another</source>
            <translation>Eine Farbe; Flicken in einer anderen</translation>
        </message>
        <message>
            <source>&amp;Zebra</source>
            <translation>&amp;Zebra</translation>
        </message>
        <message>
            <source>Reflected stripes: kinks show where tangents or curvature jump</source>
            <translation>Gespiegelte Streifen: Knicke zeigen, wo Tangenten oder Krümmung springen</translation>
        </message>
        <message>
            <source>&amp;Isophotes</source>
            <translation>&amp;Isophoten</translation>
        </message>
        <message>
            <source>Bands of equal brightness</source>
            <translation>Bänder gleicher Helligkeit</translation>
        </message>
        <message>
            <source>&amp;Wireframe</source>
            <translation>&amp;Drahtgitter</translation>
        </message>
        <message>
            <source>Draw the triangles' edges</source>
            <translation>Die Kanten der Dreiecke zeichnen</translation>
        </message>
        <message>
            <source>&amp;Frame everything</source>
            <translation>Alles &amp;zeigen</translation>
        </message>
        <message>
            <source>See the whole scene</source>
            <translation>Die ganze Szene sehen</translation>
        </message>
        <message>
            <source>&amp;Step</source>
            <translation>&amp;Schritt</translation>
        </message>
        <message>
            <source>Take one time step</source>
            <translation>Einen Zeitschritt machen</translation>
        </message>
        <message>
            <source>&amp;Run or pause</source>
            <translation>&amp;Lauf oder Pause</translation>
        </message>
        <message>
            <source>&amp;Accept or open again</source>
            <translation>&amp;Annehmen oder wieder öffnen</translation>
        </message>
        <message>
            <source>Keep the patch as it is, or take it up again</source>
            <translation>Den Flicken so lassen oder wieder aufnehmen</translation>
        </message>
        <message>
            <source>Throw the patch away; the hole is open again</source>
            <translation>Den Flicken wegwerfen; das Loch ist wieder offen</translation>
        </message>
        <message>
            <source>&amp;Copy command line</source>
            <translation>Befehlszeile &amp;kopieren</translation>
        </message>
        <message>
            <source>Copy the commands that do the same</source>
            <translation>Die Befehle kopieren, die dasselbe tun</translation>
        </message>
        <message>
            <source>Ca&amp;ncel</source>
            <translation>Abb&amp;rechen</translation>
        </message>
        <message>
            <source>Stop at once; or close a message; or select nothing</source>
            <translation>Sofort anhalten; oder Meldung schließen; oder nichts auswählen</translation>
        </message>
        <message>
            <source>How things are done, with pictures</source>
            <translation>Wie es geht, mit Bildern</translation>
        </message>
        <message>
            <source>&amp;Keyboard shortcuts</source>
            <translation>&amp;Tastenkürzel</translation>
        </message>
        <message>
            <source>All keys on one sheet</source>
            <translation>Alle Tasten auf einem Blatt</translation>
        </message>
        <message>
            <source>A&amp;bout Loopmend</source>
            <translation>Ü&amp;ber Loopmend</translation>
        </message>
        <message>
            <source>Version and licence</source>
            <translation>Version und Lizenz</translation>
        </message>
        <message>
            <source>&amp;Values in the middle</source>
            <translation>&amp;Werte in der Mitte</translation>
        </message>
        <message>
            <source>Show the values at the middle of the picture</source>
            <translation>Die Werte in der Mitte des Bildes zeigen</translation>
        </message>
        <message>
            <source>&amp;Compare flows…</source>
            <translation>&amp;Flüsse vergleichen…</translation>
        </message>
        <message>
            <source>Several flows from one start, side by side</source>
            <translation>Mehrere Flüsse von einem Anfang, nebeneinander</translation>
        </message>
        <message>
            <source>&amp;Region</source>
            <translation>&amp;Gebiet</translation>
        </message>
        <message>
            <source>Surface through &amp;points</source>
            <translation>Fläche durch &amp;Punkte</translation>
        </message>
        <message>
            <source>A smooth surface through the vertices of a polyhedron</source>
            <translation>Eine glatte Fläche durch die Ecken eines Polyeders</translation>
        </message>
        <message>
            <source>&amp;Tools</source>
            <translation>&amp;Werkzeuge</translation>
        </message>
        <message>
            <source>Compare</source>
            <translation>Vergleichen</translation>
        </message>
        <message>
            <source>Brid&amp;ge</source>
            <translation>B&amp;rücke</translation>
        </message>
        <message>
            <source>Part a hole into two by a strip between two of its vertices</source>
            <translation>Ein Loch durch einen Streifen zwischen zweien seiner Ecken in zwei teilen</translation>
        </message>
        <message>
            <source>&amp;Boundaries and seams</source>
            <translation>&amp;Ränder und Nähte</translation>
        </message>
        <message>
            <source>Draw boundaries and seams as lines</source>
            <translation>Ränder und Nähte als Linien zeichnen</translation>
        </message>
        <message>
            <source>&amp;Blend boundaries</source>
            <translation>Ränder &amp;verbinden</translation>
        </message>
        <message>
            <source>Join two or more boundaries by one patch</source>
            <translation>Zwei oder mehr Ränder durch einen Flicken verbinden</translation>
        </message>
        <message>
            <source>&amp;Fill and smooth</source>
            <translation>&amp;Füllen und glätten</translation>
        </message>
        <message>
            <source>Close the selected holes, or all, by fair patches</source>
            <translation>Die gewählten Löcher oder alle durch glatte Flicken schließen</translation>
        </message>
        <message>
            <source>Initial &amp;patch only</source>
            <translation>Nur &amp;erster Flicken</translation>
        </message>
        <message>
            <source>Close the selected holes, or all; no flow runs yet</source>
            <translation>Die gewählten Löcher oder alle schließen; noch läuft kein Fluss</translation>
        </message>
        <message>
            <source>Smooth, every step shown for a moment</source>
            <translation>Glätten, jeder Schritt einen Augenblick lang gezeigt</translation>
        </message>
        <message>
            <source>&amp;Scan colours</source>
            <translation>Farben des &amp;Scans</translation>
        </message>
        <message>
            <source>The scan's own colours or texture</source>
            <translation>Die eigenen Farben oder die Textur des Scans</translation>
        </message>
        <message>
            <source>Colours</source>
            <translation>Farben</translation>
        </message>
        <message>
            <source>&amp;Orthographic</source>
            <translation>&amp;Orthografisch</translation>
        </message>
        <message>
            <source>Without perspective: what is parallel stays so</source>
            <translation>Ohne Perspektive: was parallel ist, bleibt es</translation>
        </message>
        <message>
            <source>&amp;Front</source>
            <translation>&amp;Vorn</translation>
        </message>
        <message>
            <source>See everything from the front</source>
            <translation>Alles von vorn sehen</translation>
        </message>
        <message>
            <source>&amp;Back</source>
            <translation>&amp;Hinten</translation>
        </message>
        <message>
            <source>See everything from the back</source>
            <translation>Alles von hinten sehen</translation>
        </message>
        <message>
            <source>&amp;Left</source>
            <translation>&amp;Links</translation>
        </message>
        <message>
            <source>See everything from the left</source>
            <translation>Alles von links sehen</translation>
        </message>
        <message>
            <source>&amp;Right</source>
            <translation>&amp;Rechts</translation>
        </message>
        <message>
            <source>See everything from the right</source>
            <translation>Alles von rechts sehen</translation>
        </message>
        <message>
            <source>&amp;Top</source>
            <translation>&amp;Oben</translation>
        </message>
        <message>
            <source>See everything from above</source>
            <translation>Alles von oben sehen</translation>
        </message>
        <message>
            <source>B&amp;ottom</source>
            <translation>&amp;Unten</translation>
        </message>
        <message>
            <source>See everything from below</source>
            <translation>Alles von unten sehen</translation>
        </message>
        <message>
            <source>Tri&amp;m the boundary</source>
            <translation>Rand beschnei&amp;den</translation>
        </message>
        <message>
            <source>Remove bad triangles at the boundaries of the selected holes, or of all</source>
            <translation>Schlechte Dreiecke an den Rändern der gewählten oder aller Löcher entfernen</translation>
        </message>
        <message>
            <source>Stitc&amp;h cracks</source>
            <translation>Risse &amp;vernähen</translation>
        </message>
        <message>
            <source>Zip boundaries that nearly coincide</source>
            <translation>Ränder schließen, die fast zusammenfallen</translation>
        </message>
        <message>
            <source>Repai&amp;r…</source>
            <translation>Repa&amp;rieren…</translation>
        </message>
        <message>
            <source>See what is wrong with the scan, and mend it</source>
            <translation>Sehen, was am Scan nicht stimmt, und es beheben</translation>
        </message>
        <message>
            <source>&amp;Discard</source>
            <translation>&amp;Verwerfen</translation>
        </message>
        <message>
            <source>C&amp;lipping plane</source>
            <translation>S&amp;chnittebene</translation>
        </message>
        <message>
            <source>Cut the surfaces open across the line of sight, to see the inside</source>
            <translation>Die Flächen quer zur Blickrichtung aufschneiden, um das Innere zu sehen</translation>
        </message>
        <message>
            <source>&amp;Distance</source>
            <translation>A&amp;bstand</translation>
        </message>
        <message>
            <source>The distance between two vertices</source>
            <translation>Der Abstand zweier Ecken</translation>
        </message>
        <message>
            <source>&amp;Hide piece</source>
            <translation>Stück a&amp;usblenden</translation>
        </message>
        <message>
            <source>Hide the piece under the mouse, or those of the selected holes; it is filled and exported as before</source>
            <translation>Das Stück unter der Maus ausblenden oder die der gewählten Löcher; gefüllt und exportiert wird es wie zuvor</translation>
        </message>
        <message>
            <source>&amp;Isolate piece</source>
            <translation>Nur dieses Stück &amp;zeigen</translation>
        </message>
        <message>
            <source>Hide all other pieces</source>
            <translation>Alle anderen Stücke ausblenden</translation>
        </message>
        <message>
            <source>Sho&amp;w all pieces</source>
            <translation>A&amp;lle Stücke einblenden</translation>
        </message>
        <message>
            <source>Show everything that was hidden</source>
            <translation>Alles Ausgeblendete einblenden</translation>
        </message>
        <message>
            <source>Fill a &amp;part…</source>
            <translation>Einen &amp;Teil füllen…</translation>
        </message>
        <message>
            <source>Click two vertices of a hole; the part between them is filled</source>
            <translation>Zwei Ecken eines Lochs anklicken; der Teil dazwischen wird gefüllt</translation>
        </message>
        <message>
            <source>Part where it to&amp;uches itself</source>
            <translation>Te&amp;ilen, wo er sich berührt</translation>
        </message>
        <message>
            <source>Part the boundary at vertices that it passes twice: what hangs there becomes an island</source>
            <translation>Den Rand an Ecken teilen, durch die er zweimal läuft: was dort hängt, wird eine Insel</translation>
        </message>
        <message>
            <source>&amp;Erase a ring of faces</source>
            <translation>Einen R&amp;ing von Flächen löschen</translation>
        </message>
        <message>
            <source>Widen the selected holes by one ring of faces, where they are ragged; once more for another</source>
            <translation>Die gewählten Löcher um einen Ring von Flächen weiten, wo sie ausgefranst sind; noch einmal für einen weiteren</translation>
        </message>
        <message>
            <source>Make a region of a surface smooth, its neighborhood held</source>
            <translation>Ein Gebiet einer Fläche glätten, die Umgebung gehalten</translation>
        </message>
        <message>
            <source>Trim crossin&amp;g triangles</source>
            <translation>Kreuzende Dreiecke beschnei&amp;den</translation>
        </message>
        <message>
            <source>At the boundaries of the selected holes, or of all, remove only the triangles that run through the surface: no patch could be valid there</source>
            <translation>An den Rändern der gewählten Löcher, oder aller, nur die Dreiecke entfernen, die durch die Fläche laufen: dort kann kein Flicken gültig sein</translation>
        </message>
    </context>
    <context>
        <name>loopmend::labels</name>
        <message>
            <source>hole</source>
            <translation>Loch</translation>
        </message>
        <message>
            <source>outer rim</source>
            <translation>Außenrand</translation>
        </message>
        <message>
            <source>crack</source>
            <translation>Riss</translation>
        </message>
        <message>
            <source>cut</source>
            <translation>Schnitt</translation>
        </message>
        <message>
            <source>A hole in the surface.</source>
            <translation>Ein Loch in der Fläche.</translation>
        </message>
        <message>
            <source>open</source>
            <translation>offen</translation>
        </message>
        <message>
            <source>left out</source>
            <translation>ausgelassen</translation>
        </message>
        <message>
            <source>filled</source>
            <translation>gefüllt</translation>
        </message>
        <message>
            <source>running</source>
            <translation>läuft</translation>
        </message>
        <message>
            <source>in progress</source>
            <translation>unterwegs</translation>
        </message>
        <message>
            <source>converged</source>
            <translation>konvergiert</translation>
        </message>
        <message>
            <source>faired</source>
            <translation>geglättet</translation>
        </message>
        <message>
            <source>stopped early</source>
            <translation>früh beendet</translation>
        </message>
        <message>
            <source>cuts surface</source>
            <translation>schneidet</translation>
        </message>
        <message>
            <source>accepted</source>
            <translation>angenommen</translation>
        </message>
        <message>
            <source>failed</source>
            <translation>misslungen</translation>
        </message>
        <message>
            <source>Not filled yet.</source>
            <translation>Noch nicht gefüllt.</translation>
        </message>
        <message>
            <source>Not filled unless you select it yourself.</source>
            <translation>Wird nur gefüllt, wenn Sie es selbst auswählen.</translation>
        </message>
        <message>
            <source>Closed by the initial patch; no flow has run yet.</source>
            <translation>Durch die erste Fläche geschlossen; noch lief kein Fluss.</translation>
        </message>
        <message>
            <source>A flow is moving this patch now.</source>
            <translation>Ein Fluss bewegt diesen Flicken gerade.</translation>
        </message>
        <message>
            <source>A flow has moved this patch; more steps can be taken.</source>
            <translation>Ein Fluss hat diesen Flicken bewegt; weitere Schritte sind möglich.</translation>
        </message>
        <message>
            <source>The flow has converged to its steady state.</source>
            <translation>Der Fluss ist konvergiert: Sein stationärer Zustand ist erreicht.</translation>
        </message>
        <message>
            <source>Shaped by linear fairing, not by the flow.</source>
            <translation>Durch lineare Glättung geformt, nicht durch den Fluss.</translation>
        </message>
        <message>
            <source>Accepted: no flow moves it until you open it again.</source>
            <translation>Angenommen: kein Fluss bewegt ihn, bis Sie ihn wieder öffnen.</translation>
        </message>
        <message>
            <source>MMCVF – curvature</source>
            <translation>MMCVF – Krümmung</translation>
        </message>
        <message>
            <source>WF – tangent, round</source>
            <translation>WF – Tangente, rund</translation>
        </message>
        <message>
            <source>SDF – tangent, taut</source>
            <translation>SDF – Tangente, straff</translation>
        </message>
        <message>
            <source>MCF – position, soap film</source>
            <translation>MCF – Lage, Seifenhaut</translation>
        </message>
        <message>
            <source>Minimal mean-curvature variation, sixth order: position, tangent and curvature match at the seam.</source>
            <translation>Kleinste Änderung der mittleren Krümmung, sechste Ordnung: Lage, Tangente und Krümmung passen an der Naht.</translation>
        </message>
        <message>
            <source>Willmore flow, fourth order: position and tangent match; bends as little as possible.</source>
            <translation>Willmore-Fluss, vierte Ordnung: Lage und Tangente passen; biegt sich so wenig wie möglich.</translation>
        </message>
        <message>
            <source>Surface diffusion, fourth order: position and tangent match; mean curvature spreads evenly.</source>
            <translation>Flächendiffusion, vierte Ordnung: Lage und Tangente passen; mittlere Krümmung verteilt sich gleichmäßig.</translation>
        </message>
        <message>
            <source>Mean curvature flow, second order: least area; a crease stays at the seam.</source>
            <translation>Mittlerer Krümmungsfluss, zweite Ordnung: kleinste Fläche; an der Naht bleibt eine Falte.</translation>
        </message>
        <message>
            <source>Tangent and curvature run through the seam.</source>
            <translation>Tangente und Krümmung laufen durch die Naht.</translation>
        </message>
        <message>
            <source>The patch meets the scan with a crease of %1° (rms).</source>
            <translation>Der Flicken trifft den Scan mit einer Falte von %1° (rms).</translation>
        </message>
        <message>
            <source>The tangent runs through the seam; the mean curvature jumps by %1 (rms).</source>
            <translation>Die Tangente läuft durch die Naht; die mittlere Krümmung springt um %1 (rms).</translation>
        </message>
        <message>
            <source>No flow has run yet.</source>
            <translation>Noch lief kein Fluss.</translation>
        </message>
        <message>
            <source>Fairing made the jump of curvature %1 times smaller.</source>
            <translation>Die Glättung machte den Sprung der Krümmung %1-mal kleiner.</translation>
        </message>
        <message>
            <source>The flow made the jump of curvature %1 times smaller.</source>
            <translation>Der Fluss machte den Sprung der Krümmung %1-mal kleiner.</translation>
        </message>
        <message>
            <source>smooth</source>
            <translation>glatt</translation>
        </message>
        <message>
            <source>noisy</source>
            <translation>verrauscht</translation>
        </message>
        <message>
            <source>rough</source>
            <translation>rau</translation>
        </message>
        <message>
            <source>%1 of %2</source>
            <translation>%1 von %2</translation>
        </message>
        <message>
            <source>hole %1</source>
            <translation>Loch %1</translation>
        </message>
        <message>
            <source>holes %1 and %2</source>
            <translation>Löcher %1 und %2</translation>
        </message>
        <message>
            <source>Noted: %1.</source>
            <translation>Bemerkt: %1.</translation>
        </message>
        <message>
            <source>Will not be saved: %1.</source>
            <translation>Wird nicht gespeichert: %1.</translation>
        </message>
        <message numerus="yes">
            <source>%1 polygons cut into triangles</source>
            <translation>
                <numerusform>%1 Vieleck in Dreiecke zerlegt</numerusform>
                <numerusform>%1 Vielecke in Dreiecke zerlegt</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1 faces turned round</source>
            <translation>
                <numerusform>%1 Fläche umgedreht</numerusform>
                <numerusform>%1 Flächen umgedreht</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1 degenerate faces left aside</source>
            <translation>
                <numerusform>%1 entartete Fläche beiseitegelassen</numerusform>
                <numerusform>%1 entartete Flächen beiseitegelassen</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1 duplicate faces left aside</source>
            <translation>
                <numerusform>%1 doppelte Fläche beiseitegelassen</numerusform>
                <numerusform>%1 doppelte Flächen beiseitegelassen</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>cut along %1 non-manifold edges</source>
            <translation>
                <numerusform>an %1 nicht-mannigfaltigen Kante getrennt</numerusform>
                <numerusform>an %1 nicht-mannigfaltigen Kanten getrennt</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>split at %1 non-manifold vertices</source>
            <translation>
                <numerusform>an %1 nicht-mannigfaltigen Ecke getrennt</numerusform>
                <numerusform>an %1 nicht-mannigfaltigen Ecken getrennt</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1 vertices that no face uses</source>
            <translation>
                <numerusform>%1 Ecke ohne Fläche</numerusform>
                <numerusform>%1 Ecken ohne Fläche</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1 vertices without a colour, made white</source>
            <translation>
                <numerusform>%1 Ecke ohne Farbe, weiß gemacht</numerusform>
                <numerusform>%1 Ecken ohne Farbe, weiß gemacht</numerusform>
            </translation>
        </message>
        <message>
            <source>normals</source>
            <translation>Normalen</translation>
        </message>
        <message>
            <source>face normals</source>
            <translation>Flächennormalen</translation>
        </message>
        <message>
            <source>texture coordinates</source>
            <translation>Texturkoordinaten</translation>
        </message>
        <message>
            <source>texture coordinates of faces</source>
            <translation>Texturkoordinaten von Flächen</translation>
        </message>
        <message>
            <source>face colours</source>
            <translation>Flächenfarben</translation>
        </message>
        <message>
            <source>vertex colours</source>
            <translation>Eckenfarben</translation>
        </message>
        <message>
            <source>alpha values</source>
            <translation>Alphawerte</translation>
        </message>
        <message>
            <source>vertices without faces</source>
            <translation>Ecken ohne Flächen</translation>
        </message>
        <message>
            <source>materials</source>
            <translation>Materialien</translation>
        </message>
        <message>
            <source>material libraries</source>
            <translation>Materialbibliotheken</translation>
        </message>
        <message>
            <source>objects</source>
            <translation>Objekte</translation>
        </message>
        <message>
            <source>groups</source>
            <translation>Gruppen</translation>
        </message>
        <message>
            <source>smoothing groups</source>
            <translation>Glättungsgruppen</translation>
        </message>
        <message>
            <source>lines</source>
            <translation>Linien</translation>
        </message>
        <message>
            <source>points</source>
            <translation>Punkte</translation>
        </message>
        <message numerus="yes">
            <source>%1 boundary edges that lie exactly on another (the mesh is split there; Stitch joins them)</source>
            <translation>
                <numerusform>%1 Randkante, die genau auf einer anderen liegt (das Netz ist dort getrennt; Vernähen verbindet sie)</numerusform>
                <numerusform>%1 Randkanten, die genau auf einer anderen liegen (das Netz ist dort getrennt; Vernähen verbindet sie)</numerusform>
            </translation>
        </message>
        <message>
            <source>The outline of an open sheet. It is left out unless you select it yourself and press Fill.</source>
            <translation>Der Rand einer offenen Fläche. Er bleibt aus, wenn Sie ihn nicht selbst auswählen und füllen.</translation>
        </message>
        <message>
            <source>Relief around the hole is %1 % of an edge high, noise %2 %. The fits tell the normal at the boundary to %3° and the mean curvature to %4 (it is %5 there, rms); the band in the section shows it.</source>
            <translation>Das Relief um das Loch ist %1 % einer Kante hoch, das Rauschen %2 %. Die Anpassungen bestimmen die Normale am Rand auf %3° und die mittlere Krümmung auf %4 (sie beträgt dort %5, Effektivwert); das Band im Schnitt zeigt es.</translation>
        </message>
        <message>
            <source>separate solids</source>
            <translation>einzelne Körper</translation>
        </message>
        <message>
            <source>face attributes</source>
            <translation>Flächenattribute</translation>
        </message>
        <message>
            <source>names of no face</source>
            <translation>Namen ohne Fläche</translation>
        </message>
        <message>
            <source>display statements</source>
            <translation>Anzeigeanweisungen</translation>
        </message>
        <message>
            <source>the surface is inside out</source>
            <translation>die Fläche ist umgestülpt</translation>
        </message>
        <message>
            <source>Watertight, ready to print</source>
            <translation>Wasserdicht, druckbar</translation>
        </message>
        <message>
            <source>Watertight, not ready to print: %1</source>
            <translation>Wasserdicht, nicht druckbar: %1</translation>
        </message>
        <message>
            <source>Not watertight: %1 and more</source>
            <translation>Nicht wasserdicht: %1 und mehr</translation>
        </message>
        <message>
            <source>Not watertight: %1</source>
            <translation>Nicht wasserdicht: %1</translation>
        </message>
        <message>
            <source>volume %1, in cubic units of the scan</source>
            <translation>Rauminhalt %1, in Kubikeinheiten des Scans</translation>
        </message>
        <message numerus="yes">
            <source>%1 touching boundary vertices joined</source>
            <translation>
                <numerusform>%1 Randpunkt an derselben Stelle verbunden</numerusform>
                <numerusform>%1 Randpunkte an derselben Stelle verbunden</numerusform>
            </translation>
        </message>
        <message>
            <source>micrometres</source>
            <translation>Mikrometern</translation>
        </message>
        <message>
            <source>millimetres</source>
            <translation>Millimetern</translation>
        </message>
        <message>
            <source>centimetres</source>
            <translation>Zentimetern</translation>
        </message>
        <message>
            <source>metres</source>
            <translation>Metern</translation>
        </message>
        <message>
            <source>inches</source>
            <translation>Zoll</translation>
        </message>
        <message>
            <source>feet</source>
            <translation>Fuß</translation>
        </message>
        <message>
            <source>not known</source>
            <translation>nicht bekannt</translation>
        </message>
        <message>
            <source>A crack: nothing is missing here, the two sides only are not joined. Stitch joins them.</source>
            <translation>Ein Riss: hier fehlt nichts, die zwei Seiten sind nur nicht verbunden. Vernähen verbindet sie.</translation>
        </message>
        <message>
            <source>Not a hole: more than two triangles meet along this edge, so the surface was cut here. Repair… in the tab Patch lists such edges and removes them.</source>
            <translation>Kein Loch: mehr als zwei Dreiecke treffen sich an dieser Kante, deshalb wurde die Fläche hier getrennt. Reparieren… im Reiter Flicken führt solche Kanten auf und entfernt sie.</translation>
        </message>
        <message>
            <source>The flow stopped before it converged; this is its last good state. Run goes on from here; Accept keeps it.</source>
            <translation>Der Fluss hielt an, bevor er konvergierte; dies ist sein letzter guter Zustand. Lauf macht hier weiter; Annehmen behält ihn.</translation>
        </message>
        <message>
            <source>This patch cuts the surface or itself. It is not exported unless you accept it. Discard opens the hole again; then trim its boundary, or erase a ring of faces, and fill anew.</source>
            <translation>Dieser Flicken schneidet die Fläche oder sich selbst. Er wird nur exportiert, wenn Sie ihn annehmen. Verwerfen öffnet das Loch wieder; dann den Rand beschneiden oder einen Ring von Flächen löschen und neu füllen.</translation>
        </message>
        <message>
            <source>This hole could not be filled. Trim its boundary, erase a ring of faces around it, or bridge it, and fill again.</source>
            <translation>Dieses Loch ließ sich nicht füllen. Seinen Rand beschneiden, einen Ring von Flächen um es löschen oder es überbrücken, dann wieder füllen.</translation>
        </message>
        <message>
            <source>%1: %2, %3, %4.</source>
            <translation>%1: %2, %3, %4.</translation>
        </message>
        <message numerus="yes">
            <source>%1 triangles</source>
            <translation>
                <numerusform>%1 Dreieck</numerusform>
                <numerusform>%1 Dreiecke</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1 vertices</source>
            <translation>
                <numerusform>%1 Ecke</numerusform>
                <numerusform>%1 Ecken</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1 boundary loops</source>
            <translation>
                <numerusform>%1 Rand</numerusform>
                <numerusform>%1 Ränder</numerusform>
            </translation>
        </message>
        <message>
            <source>The scan around the hole is too small for its seam to be measured.</source>
            <translation>Der Scan um das Loch ist zu klein, um seine Naht zu messen.</translation>
        </message>
        <message numerus="yes">
            <source>%Ln open boundary loop(s)</source>
            <translation>
                <numerusform>%Ln offene Randschleife</numerusform>
                <numerusform>%Ln offene Randschleifen</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln edge(s) of more than two faces</source>
            <translation>
                <numerusform>%Ln Kante mit mehr als zwei Flächen</numerusform>
                <numerusform>%Ln Kanten mit mehr als zwei Flächen</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln edge(s) whose faces look to opposite sides</source>
            <translation>
                <numerusform>%Ln Kante, deren Flächen nach verschiedenen Seiten schauen</numerusform>
                <numerusform>%Ln Kanten, deren Flächen nach verschiedenen Seiten schauen</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln pair(s) of faces that intersect</source>
            <translation>
                <numerusform>%Ln Paar Flächen, die sich schneiden</numerusform>
                <numerusform>%Ln Paare Flächen, die sich schneiden</numerusform>
            </translation>
        </message>
        <message>
            <source>%L1 holes</source>
            <translation>%L1 Löcher</translation>
        </message>
        <message numerus="yes">
            <source>%Ln piece(s) of surface</source>
            <translation>
                <numerusform>%Ln Flächenstück</numerusform>
                <numerusform>%Ln Flächenstücke</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln edge(s) along which it touches itself</source>
            <translation>
                <numerusform>%Ln Kante, an der sie sich selbst berührt</numerusform>
                <numerusform>%Ln Kanten, an denen sie sich selbst berührt</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1 vertices joined along cracks no wider than rounding</source>
            <translation>
                <numerusform>%1 Ecke an einem Riss von der Breite der Rundung verbunden</numerusform>
                <numerusform>%1 Ecken an Rissen von der Breite der Rundung verbunden</numerusform>
            </translation>
        </message>
        <message>
            <source>look</source>
            <translation>ansehen</translation>
        </message>
        <message>
            <source>bad</source>
            <translation>schlecht</translation>
        </message>
        <message>
            <source>Filled; look at this patch before you accept it.</source>
            <translation>Gefüllt; diesen Flicken vor dem Annehmen ansehen.</translation>
        </message>
        <message>
            <source>Filled, but the patch has a fault: look at it, then accept it, or discard it and trim the boundary.</source>
            <translation>Gefüllt, aber der Flicken hat einen Fehler: ansehen, dann annehmen, oder verwerfen und den Rand beschneiden.</translation>
        </message>
        <message numerus="yes">
            <source>crosses the surface or itself in %Ln place(s)</source>
            <translation>
                <numerusform>schneidet die Fläche oder sich selbst an %Ln Stelle</numerusform>
                <numerusform>schneidet die Fläche oder sich selbst an %Ln Stellen</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%Ln edge(s) folded by more than 150°</source>
            <translation>
                <numerusform>%Ln um mehr als 150° gefaltete Kante</numerusform>
                <numerusform>%Ln um mehr als 150° gefaltete Kanten</numerusform>
            </translation>
        </message>
        <message>
            <source>a crease of %1° along %2 edges of the seam, where the initial patch had %3°</source>
            <translation>ein Knick von %1° entlang %2 Kanten der Naht, wo der erste Flicken %3° hatte</translation>
        </message>
        <message>
            <source>a dome %1 diameters high over a flat loop</source>
            <translation>eine Kuppel, %1 Durchmesser hoch, über einem flachen Rand</translation>
        </message>
        <message>
            <source>a bubble of %1 times the area of the initial patch, reaching %2 diameters beyond it</source>
            <translation>eine Blase mit dem %1-Fachen der Fläche des ersten Flickens, die %2 Durchmesser darüber hinausreicht</translation>
        </message>
        <message>
            <source>mean curvature jumps at the seam by %1 / diameter, before the flow by %2</source>
            <translation>die mittlere Krümmung springt an der Naht um %1 / Durchmesser, vor dem Fluss um %2</translation>
        </message>
        <message>
            <source>no flow or fairing gave a sound patch: the initial patch was kept</source>
            <translation>kein Fluss und keine Glättung ergab einen fehlerfreien Flicken: der erste Flicken wurde behalten</translation>
        </message>
        <message>
            <source>a crease of %1° along %2 edges of the seam</source>
            <translation>ein Knick von %1° entlang %2 Kanten der Naht</translation>
        </message>
        <message>
            <source>rises %1 diameters over its loop; a ball through the seam would rise %2</source>
            <translation>erhebt sich %1 Durchmesser über seinen Rand; eine Kugel durch die Naht erhöbe sich %2</translation>
        </message>
        <message>
            <source>all steps taken</source>
            <translation>alle Schritte getan</translation>
        </message>
        <message>
            <source>The flow has taken the steps that were planned for this hole.</source>
            <translation>Der Fluss hat die Schritte getan, die für dieses Loch geplant waren.</translation>
        </message>
        <message>
            <source>what was there may lie %1 diameters away: the shape is a guess</source>
            <translation>was dort war, liegt vielleicht %1 Durchmesser entfernt: Die Form ist geraten</translation>
        </message>
        <message>
            <source>Likely within %1 of what was there (80 %).</source>
            <translation>Wahrscheinlich höchstens %1 von dem entfernt, was dort war (80 %).</translation>
        </message>
        <message>
            <source>copied from the mirror image, from which the surface around is %1 diameters away</source>
            <translation>vom Spiegelbild kopiert, von dem die Fläche ringsum %1 Durchmesser entfernt ist</translation>
        </message>
        <message>
            <source>not copied from the mirror image, from which the surface around is %1 diameters away; from a quadric it is %2</source>
            <translation>nicht vom Spiegelbild kopiert, von dem die Fläche ringsum %1 Durchmesser entfernt ist; von einer Quadrik sind es %2</translation>
        </message>
        <message>
            <source>not copied from the mirror image, since the scan is not symmetric: its best image is %1 of its extent away</source>
            <translation>nicht vom Spiegelbild kopiert, da der Scan nicht symmetrisch ist: Sein bestes Spiegelbild ist %1 seiner Ausdehnung entfernt</translation>
        </message>
        <message>
            <source>not copied from the mirror image, which has no surface there</source>
            <translation>nicht vom Spiegelbild kopiert, das dort keine Fläche hat</translation>
        </message>
        <message>
            <source>not copied from the mirror image, which folds there, cuts the surface or does not close the hole</source>
            <translation>nicht vom Spiegelbild kopiert, das sich dort faltet, die Fläche schneidet oder das Loch nicht schließt</translation>
        </message>
    </context>
</TS>
