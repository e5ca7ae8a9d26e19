// What the modules say in English, in German: what is wrong with a file, and what was left out of it. Found by the English
// templates as they stand in the Rust sources, with `{}` for each value, in their order. In the German, `{*}` is a value that
// is a sentence, or a list of things, itself.

/** @type {Record<string, string>} */
export const sentences = {
  "the drawing has more than {} pieces of line, or too many on one spot; simplify it or split it":
    "die Zeichnung hat mehr als {} Linienstücke, oder zu viele an einer Stelle; vereinfache oder teile sie",
  "the lines of the drawing could not be triangulated; please report this drawing":
    "die Linien der Zeichnung ließen sich nicht in Dreiecke zerlegen; bitte melde diese Zeichnung",
  "a region of the drawing has too much detail to be coloured; simplify it or divide it with a line":
    "ein Bereich der Zeichnung hat zu viele Einzelheiten, um Farbe zu bekommen; vereinfache ihn, oder teile ihn mit einer Linie",
  "a region of the drawing could not be solved; please report this drawing":
    "ein Bereich der Zeichnung ließ sich nicht berechnen; bitte melde diese Zeichnung",
  "the scribbles are too long in all; erase some of them": "die Kritzel sind zusammen zu lang; radiere einige davon",
  "what is to be painted is damaged": "was gemalt werden soll, ist beschädigt",
  "what the browser kept of the drawing is damaged; open it from a file":
    "was der Browser von der Zeichnung behalten hat, ist beschädigt; öffne sie aus einer Datei",

  "the file is empty; choose an SVG file": "die Datei ist leer; wähle eine SVG-Datei",
  "the file is larger than the {} MB that can be opened; simplify the drawing or remove its pictures":
    "die Datei ist größer als die {} MB, die sich öffnen lassen; vereinfache die Zeichnung, oder nimm ihre Bilder heraus",
  "the file is compressed (SVGZ); unpack it with gzip, or save it as plain SVG":
    "die Datei ist komprimiert (SVGZ); entpacke sie mit gzip, oder sichere sie als einfaches SVG",
  "the file is in UTF-16; save it in UTF-8": "die Datei ist in UTF-16; sichere sie in UTF-8",
  "the file is a {} file; save it as SVG in the program that made it":
    "die Datei ist eine {}-Datei; sichere sie als SVG in dem Programm, das sie gemacht hat",
  "the file is not an SVG drawing: it is no text in UTF-8; save it so, or choose an SVG file":
    "die Datei ist keine SVG-Zeichnung: sie ist kein Text in UTF-8; sichere sie so, oder wähle eine SVG-Datei",
  "this is no SVG drawing, or it is damaged: {}; save it again, or choose another":
    "das ist keine SVG-Zeichnung, oder sie ist beschädigt: {*}; sichere sie noch einmal, oder wähle eine andere",
  "the diffusion curves are damaged: {}; mend the file there, or save it again":
    "die Diffusionskurven sind beschädigt: {*}; bessere die Datei dort aus, oder sichere sie noch einmal",
  "this is no drawing: it starts with <{}>, not with <svg>, nor with <curve_set> as diffusion curves do; choose another":
    "das ist keine Zeichnung: es beginnt mit <{}>, nicht mit <svg>, auch nicht mit <curve_set> wie Diffusionskurven; wähle eine andere",
  "the file declares XML entities that could grow without bound; save it again without them":
    "die Datei hat XML-Entitäten, die grenzenlos wachsen könnten; sichere sie noch einmal ohne diese",
  "the drawing has more than 200,000 elements, counting the copies that <use> makes; simplify it or split it":
    "die Zeichnung hat mehr als 200.000 Elemente, Kopien durch <use> mitgezählt; vereinfache oder teile sie",
  "the drawing has groups within groups too deep (at most {}, fewer in large drawings); ungroup it and save it again":
    "die Zeichnung hat Gruppen zu tief in Gruppen (höchstens {}, in großen Zeichnungen weniger); löse sie auf und sichere die Zeichnung noch einmal",
  "elements of the drawing refer to each other in a circle, or in a long chain; replace the <use> elements or gradients by copies":
    "Elemente der Zeichnung verweisen im Kreis aufeinander, oder in einer langen Kette; ersetze die <use>-Elemente oder Verläufe durch Kopien",
  "the drawing has too many lines: more than 500,000 segments, long curves counting more; simplify it, scale it down or split it":
    "die Zeichnung hat zu viele Linien: mehr als 500.000 Stücke, wobei lange Kurven mehr zählen; vereinfache, verkleinere oder teile sie",
  "the file has elements with too many attributes, or too many name spaces; save it again as plain SVG":
    "die Datei hat Elemente mit zu vielen Attributen, oder zu viele Namensräume; sichere sie noch einmal als einfaches SVG",
  "the drawing has a list of dashes that is too long; use a shorter one":
    "die Zeichnung hat ein zu langes Strichmuster; nimm ein kürzeres",
  "the drawing has a line that is wider than a million units, or a mitre as long; make it smaller":
    "die Zeichnung hat eine Linie, die breiter als eine Million Einheiten ist, oder eine so lange Gehrung; mach sie kleiner",
  "the drawing has a gradient or pattern with too many parts; replace it by a plain colour":
    "die Zeichnung hat einen Verlauf oder ein Muster aus zu vielen Teilen; nimm dort eine einfache Farbe",
  "the style sheet of the drawing is too large; save the drawing with styles as attributes":
    "das Stylesheet der Zeichnung ist zu groß; sichere die Zeichnung mit Stilen als Attributen",
  "the page of the drawing has no area, or is larger than 100 million units; give it another viewBox or size":
    "die Seite der Zeichnung hat keine Fläche oder ist größer als 100 Millionen Einheiten; gib ihr eine andere viewBox oder Größe",
  "the diffusion curves have no page; give <curve_set> an image_width and an image_height above zero":
    "die Diffusionskurven haben keine Seite; gib <curve_set> eine image_width und eine image_height über null",
  "there is no diffusion curve that can be used; give each at least four control points with x and y":
    "es gibt keine brauchbare Diffusionskurve; gib jeder mindestens vier Kontrollpunkte mit x und y",
  "the drawing has more than 200,000 curves; simplify it or split it":
    "die Zeichnung hat mehr als 200.000 Kurven; vereinfache oder teile sie",
  "the drawing has no lines and no shapes to colour{}": "die Zeichnung hat keine Linien und keine Formen zum Färben{*}",
  " ({})": " ({*})",

  "the palette is larger than the {} MB that can be opened; take colours out of it":
    "die Palette ist größer als die {} MB, die sich öffnen lassen; nimm Farben heraus",
  "the file is no palette: it is neither GIMP’s (.gpl), nor Adobe Swatch Exchange (.ase), nor a list of colours #rrggbb":
    "die Datei ist keine Palette: weder eine von GIMP (.gpl) noch Adobe Swatch Exchange (.ase) noch eine Liste von Farben #rrggbb",
  "the palette has no colours; add some to it": "die Palette hat keine Farben; füge welche hinzu",
  "the palette has colours of unknown kinds alone ({} of them); save it again with them in RGB":
    "die Palette hat nur Farben unbekannter Art ({}); sichere sie noch einmal mit Farben in RGB",
  "the palette has more than {} colours; take some out of it": "die Palette hat mehr als {} Farben; nimm einige heraus",
  "the palette cannot be used: line {} should have {}; mend it there, or save the palette again":
    "die Palette ist in Zeile {} unbrauchbar, dort müsste stehen: {*}; bessere sie aus, oder sichere sie noch einmal",
  "the palette is damaged: its first twelve bytes should be ASEF, a version and the number of blocks; save it again as Adobe Swatch Exchange":
    "die Palette ist beschädigt: ihre ersten zwölf Bytes müssten ASEF, eine Version und die Zahl der Blöcke sein; sichere sie noch einmal als Adobe Swatch Exchange",
  "the palette is damaged: block {} of {} ends too soon, or says a wrong length; save or download it again":
    "die Palette ist beschädigt: Block {} von {} endet zu früh, oder nennt eine falsche Länge; sichere sie neu, oder lade sie neu herunter",

  "the file is empty; choose a .scumble file that was saved": "die Datei ist leer; wähle eine gesicherte .scumble-Datei",
  "the file is larger than the {} MB that can be opened; simplify the drawing, or trace a smaller picture":
    "die Datei ist größer als die {} MB, die sich öffnen lassen; vereinfache die Zeichnung, oder nimm eine kleinere Vorlage",
  "the file would be larger than the {} MB that can be opened; simplify the drawing, or trace a smaller picture":
    "die Datei wäre größer als die {} MB, die sich öffnen lassen; vereinfache die Zeichnung, oder nimm eine kleinere Vorlage",
  "the file is not a Scumble file: it is no text in UTF-8; choose a .scumble file":
    "die Datei ist keine Scumble-Datei: sie ist kein Text in UTF-8; wähle eine .scumble-Datei",
  'the file is not a Scumble file: it does not say {"format": "scumble", "version": "1.0", …}; choose a .scumble file':
    'die Datei ist keine Scumble-Datei: in ihr steht nicht {"format": "scumble", "version": "1.0", …}; wähle eine .scumble-Datei',
  "the file was saved by a newer Scumble, in version {} of the format; update Scumble to open it":
    "ein neueres Scumble hat die Datei gesichert, in Version {} des Formats; aktualisiere Scumble, um sie zu öffnen",
  "the file cannot be used: line {} should have {}; mend it there, or save the drawing again":
    "die Datei ist in Zeile {} unbrauchbar, dort müsste stehen: {*}; bessere sie aus, oder sichere die Zeichnung noch einmal",
  "the scribbles are longer than {} pages in all; use fewer of them":
    "die Kritzel sind zusammen länger als {} Seiten; nimm weniger davon",
  "more than {} of the scribbles shade; use fewer of them": "mehr als {} der Kritzel tönen; nimm weniger davon",

  "this is no link to a drawing: it should hold “#1.” and letters after that; copy the whole link":
    "das ist kein Link zu einer Zeichnung: darin müsste „#1.“ stehen, und Buchstaben dahinter; kopiere den ganzen Link",
  "the link is damaged: a part of it is missing or was changed; copy the whole link once more":
    "der Link ist beschädigt: ein Teil davon fehlt oder ist verändert; kopiere den ganzen Link noch einmal",
  "the link was made by a newer Scumble; update Scumble to open it":
    "ein neueres Scumble hat den Link gemacht; aktualisiere Scumble, um ihn zu öffnen",
  "the link is longer than the {} characters that can be opened; ask for the drawing as a file":
    "der Link ist länger als die {} Zeichen, die sich öffnen lassen; bitte um die Zeichnung als Datei",
  "the drawing is too large for a link; save it as a file and share that":
    "die Zeichnung ist zu groß für einen Link; sichere sie als Datei und schicke diese",

  "the file is no PNG or JPEG picture, or its beginning is missing; save the picture again as one of these":
    "die Datei ist kein Bild in PNG oder JPEG, oder ihr Anfang fehlt; sichere das Bild noch einmal als eines davon",
  "{} pictures cannot be opened; save the picture as PNG or JPEG":
    "{}-Bilder lassen sich nicht öffnen; sichere das Bild als PNG oder JPEG",
  "the picture’s file is larger than {} MiB; save it with fewer pixels, or as JPEG":
    "die Datei des Bildes ist größer als {} MiB; sichere es mit weniger Pixeln, oder als JPEG",
  "the picture has {} × {} pixels; scale it down to 16,384 a side and 64 million in all, at most":
    "das Bild hat {} × {} Pixel; verkleinere es auf höchstens 16.384 je Seite und 64 Millionen zusammen",
  "the picture is damaged: {}; save or download it again":
    "das Bild ist beschädigt: {*}; sichere es neu, oder lade es neu herunter",
  "it says that it has no pixels": "laut seinem Anfang hat es keine Pixel",
  "its end is missing": "sein Ende fehlt",
  "it does not say how large it is": "es sagt nicht, wie groß es ist",
  "a part of it was changed": "ein Teil davon ist verändert",

  "its lines alone, without the scribbles: {}": "nur die Linien, ohne die Kritzel: {*}",
  "left out: 1 colour of an unknown kind": "weggelassen: 1 Farbe unbekannter Art",
  "left out: {} colours of an unknown kind": "weggelassen: {} Farben unbekannter Art",
  "left out: {}": "weggelassen: {*}",

  "an object {…}": "ein Objekt {…}",
  "a list […]": "eine Liste […]",
  "a colon": "ein Doppelpunkt",
  "a comma, or the end of the list": "ein Komma oder das Ende der Liste",
  "less nesting": "weniger Verschachtelung",
  "fewer numbers": "weniger Zahlen",
  "more numbers before this": "davor mehr Zahlen",
  "a number": "eine Zahl",
  "a number between −1e9 and 1e9": "eine Zahl zwischen −1e9 und 1e9",
  "true or false": "true oder false",
  "a text in quotes": "ein Text in Anführungszeichen",
  "a quote at the end of a text": "ein Anführungszeichen am Ende eines Textes",
  "no control character": "kein Steuerzeichen",
  "a known escape after the backslash": "ein bekanntes Zeichen nach dem Backslash",
  "four hexadecimal digits that make a character": "vier hexadezimale Ziffern, die ein Zeichen ergeben",
  "nothing more": "nichts mehr",
  "a path in the curve before this": "in der Kurve davor ein Pfad",
  "two caps": "zwei Enden",
  "two caps before this": "davor zwei Enden",
  "a path in the fill before this": "in der Füllung davor ein Pfad",
  "as many radii or strengths as points in the scribble before this":
    "im Kritzel davor so viele Radien oder Stärken wie Punkte",
  "color, width and points in the scribble before this": "im Kritzel davor color, width und points",
  "a strength from 0 to 1 before this": "davor eine Stärke von 0 bis 1",
  "a curve's place, counted from 0, before this": "davor der Platz einer Kurve, von 0 an gezählt",
  "a width above zero before this": "davor eine Breite über null",
  "a colour #rrggbb or none before this": "davor eine Farbe #rrggbb oder none",
  "a colour #rrggbb or #rrggbbaa before this": "davor eine Farbe #rrggbb oder #rrggbbaa",
  "one path for each curve before this": "davor ein einziger Pfad für jede Kurve",
  "a path of M, L, Q, C and Z in capitals before this": "davor ein Pfad aus M, L, Q, C und Z in Großbuchstaben",
  "a name that this version knows before this; update it to open what a newer one saved":
    "davor ein Name, den diese Version kennt; aktualisiere sie, um zu öffnen, was eine neuere gesichert hat",
  "a part from 0 to 1 before this": "davor ein Teil von 0 bis 1",
  "a canvas in the file": "in der Datei eine Seite (canvas)",
  "a plain file name before this": "davor ein einfacher Dateiname",
  "a whole PNG or JPEG picture in base64, of at most 8 MiB and 64 million pixels, before this":
    "davor ein ganzes Bild in PNG oder JPEG, in base64, von höchstens 8 MiB und 64 Millionen Pixeln",
  "a canvas [x, y, width, height] with sides from 1e-6 to 1e8 before this":
    "davor eine Seite [x, y, width, height], 1e-6 bis 1e8 breit und hoch",
  "“GIMP Palette”": "„GIMP Palette“",
  "three numbers from 0 to 255": "drei Zahlen von 0 bis 255",
  "a colour #rrggbb": "eine Farbe #rrggbb",

  "'xml' namespace prefix mapped to wrong URI at {}": "das Präfix 'xml' hat bei {} eine falsche URI",
  "the 'xml' namespace URI is used for not 'xml' prefix at {}": "die URI von 'xml' hat bei {} ein anderes Präfix",
  "the 'xmlns' URI is used at {}, but it must not be declared": "die URI von 'xmlns' steht bei {}, wo sie nicht stehen darf",
  "the 'xmlns' prefix is used at {}, but it must not be": "das Präfix 'xmlns' steht bei {}, wo es nicht stehen darf",
  "namespace '{}' at {} is already defined": "den Namensraum '{}' bei {} gibt es schon",
  "an unknown namespace prefix '{}' at {}": "das Präfix '{}' bei {} ist unbekannt",
  "expected '{}' tag, not '{}' at {}": "das Tag '{}' statt '{}' erwartet bei {}",
  "unexpected close tag at {}": "unerwartetes schließendes Tag bei {}",
  "malformed entity reference at {}": "fehlerhafter Verweis auf eine Entität bei {}",
  "unknown entity reference '{}' at {}": "unbekannte Entität '{}' bei {}",
  "a possible entity reference loop is detected at {}": "Entitäten verweisen bei {} vielleicht im Kreis aufeinander",
  "unescaped '<' found at {}": "'<' statt '&lt;' bei {}",
  "attribute '{}' at {} is already defined": "das Attribut '{}' bei {} gibt es schon",
  "the document does not have a root node": "es gibt kein oberstes Element",
  "the root node was opened but never closed": "das oberste Element endet nicht",
  "unexpected XML declaration at {}": "unerwartete XML-Deklaration bei {}",
  "more than 2^32 attributes were parsed": "es gibt mehr als 2^32 Attribute",
  "more than 2^16 unique namespaces were parsed": "es gibt mehr als 2^16 Namensräume",
  "invalid name token at {}": "ungültiger Name bei {}",
  "a non-XML character {} found at {}": "das Zeichen {} darf bei {} nicht stehen",
  "expected '{}' not '{}' at {}": "'{}' statt '{}' erwartet bei {}",
  "expected {} not '{}' at {}": "{*} statt '{}' erwartet bei {}",
  "expected '{}' at {}": "'{}' erwartet bei {}",
  "invalid ExternalID at {}": "ungültige ExternalID bei {}",
  "comment at {} contains '--'": "der Kommentar bei {} enthält '--'",
  "']]>' at {} is not allowed inside a character data": "']]>' darf bei {} nicht im Text stehen",
  "unknown token at {}": "unbekanntes Zeichen bei {}",
  "unexpected end of stream": "der Text endet zu früh",
  "a quote": "ein Anführungszeichen",
  "a whitespace": "ein Leerzeichen",
  "'[' or '>'": "'[' oder '>'",
  "a quote, SYSTEM or PUBLIC": "ein Anführungszeichen, SYSTEM oder PUBLIC",
};

/** What there may be several of, behind its number. @type {Record<string, string>} */
export const things = {
  "text": "Text",
  "texts": "Texte",
  "image": "Bild",
  "images": "Bilder",
  "clip path": "Beschneidungspfad",
  "clip paths": "Beschneidungspfade",
  "mask": "Maske",
  "masks": "Masken",
  "filter": "Filter",
  "filters": "Filter",
  "marker": "Markierung",
  "markers": "Markierungen",
  "transform": "Transformation",
  "transforms": "Transformationen",
  "pattern": "Muster",
  "patterns": "Muster",
  "cover of a line that is shown whole": "Überdeckung einer Linie, die ganz gezeigt wird",
  "covers of lines that are shown whole": "Überdeckungen von Linien, die ganz gezeigt werden",
  "shape with unusable coordinates": "Form mit unbrauchbaren Koordinaten",
  "shapes with unusable coordinates": "Formen mit unbrauchbaren Koordinaten",
  "colour that cannot be read": "Farbe, die sich nicht lesen lässt",
  "colours that cannot be read": "Farben, die sich nicht lesen lassen",
  "curve’s blur": "Unschärfe einer Kurve",
  "curves’ blur": "Unschärfen von Kurven",
  "curve with unusable control points": "Kurve mit unbrauchbaren Kontrollpunkten",
  "curves with unusable control points": "Kurven mit unbrauchbaren Kontrollpunkten",
  "colour without all its numbers": "Farbe, der Zahlen fehlen",
  "colours without all their numbers": "Farben, denen Zahlen fehlen",
};

/** What a sentence may be, the longer first: a shorter one might take a part of a longer one's words for a value. */
const patterns = Object.keys(sentences)
  .sort((a, b) => b.length - a.length)
  .map((english) => ({ pattern: patternOf(english), german: sentences[english] }));

/** @param {string} english */
function patternOf(english) {
  const literals = english.split("{}").map((literal) => literal.replace(/[[\](){}.*+?^$|\\]/g, "\\$&"));
  return new RegExp(`^${literals.join("(.*?)")}$`, "s");
}

/**
 * What a module says, in German. What has none is left as it is.
 * @param {string} said a sentence, a part of one, or a list of things and their numbers
 * @returns {string}
 */
export function inGerman(said) {
  for (const { pattern, german } of patterns) {
    const values = pattern.exec(said)?.slice(1);
    if (values) return german.replace(/\{(\*?)\}/g, (_, isSaid) => (isSaid ? inGerman : String)(values.shift() ?? ""));
  }
  return said.replace(/(?<=\d )[^,]+/g, (thing) => (Object.hasOwn(things, thing) ? things[thing] : thing));
}
