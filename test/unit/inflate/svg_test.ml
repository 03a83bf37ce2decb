(* SVG: references, clips, style sheets, colours, and what is refused. *)
open Scc_pixels
open Areas

(* {1 References} *)

let references () =
  let disc = circle 20. 15. 5. in
  area "use" "<defs><circle id='a' r='5'/></defs><use href='#a' x='20' y='15'/>" disc;
  area "use by XLink, before its target"
    "<use xlink:href='#a' transform='translate(20 15)'/><defs><circle id='a' r='5'/></defs>" disc;
  area "use of a group"
    "<defs><g id='a'><circle id='b' r='5'/></g></defs><use href='#b' x='10' y='15'/><use href='#a' x='30' y='15'/>"
    (union (circle 10. 15. 5.) (circle 30. 15. 5.));
  area "use with a style that its target inherits"
    "<defs><circle id='a' r='5'/></defs><g fill='none'><use href='#a' x='20' y='15' fill='red'/></g>" disc;
  let symbol = "<symbol id='s' viewBox='0 0 10 10'><rect x='-5' width='10' height='20'/></symbol>" in
  area "symbol" (symbol ^ "<use href='#s' x='5' y='6' width='20' height='20'/>") (box 5. 6. 15. 26.);
  area "symbol, kept in proportion" (symbol ^ "<use href='#s' x='5' y='6' width='30' height='20'/>")
    (box 5. 6. 20. 26.);
  area "nested svg"
    "<svg x='5' y='5' width='20' height='20' viewBox='0 0 10 20' preserveAspectRatio='xMaxYMin'><rect width='10' \
     height='20'/></svg>"
    (box 15. 5. 25. 25.);
  area "stretched" "<svg x='5' y='5' width='30' height='10' viewBox='0 0 10 10' preserveAspectRatio='none'><rect \
                    width='10' height='5'/></svg>"
    (box 5. 5. 35. 10.);
  area "sliced" "<svg x='5' y='5' width='30' height='10' viewBox='0 0 10 10' preserveAspectRatio='xMidYMid \
                 slice'><rect y='4' width='10' height='2'/></svg>"
    (box 5. 7. 35. 13.);
  area "clipped by its viewport"
    "<svg x='5' y='5' width='10' height='10'><rect width='100' height='100'/></svg>" (box 5. 5. 15. 15.);
  area "not clipped" "<svg x='5' y='5' width='10' height='10' overflow='visible'><rect width='15' \
                      height='20'/></svg>" (box 5. 5. 20. 25.);
  area "percentages" "<svg x='10%' y='50%' width='50%' height='50%'><rect x='50%' width='50%' \
                      height='50%'/></svg>" (box 14. 15. 24. 22.5)

(* What is seen beside the viewBox of a whole drawing, by its width, height and alignment: the size in pixels and
   how many are painted. *)
let viewports () =
  let check name attributes expected =
    let text =
      Printf.sprintf
        "<svg xmlns='http://www.w3.org/2000/svg' %s><rect x='4' y='-4' width='12' height='18'/></svg>" attributes
    in
    let r = ok ~resolution:20 name text in
    let painted = ref 0 in
    Bytes.iter (fun c -> if c <> '\000' then incr painted) r.alphas;
    Alcotest.(check (triple int int int)) name expected (r.width, r.height, !painted)
  in
  let wide = "viewBox='0 0 20 10'" in
  let square = "width='20' height='20' " ^ wide in
  check "the viewBox alone" wide (20, 10, 120); check "one side" (wide ^ " width='7'") (20, 10, 120);
  check "a share" (wide ^ " width='7' height='100%'") (20, 10, 120);
  check "its proportions" (wide ^ " width='2in' height='1in'") (20, 10, 120);
  check "its proportions, in units of a font" (wide ^ " width='2em' height='1em'") (20, 10, 120);
  check "its proportions, rounded" (wide ^ " width='33.34mm' height='16.66mm'") (20, 10, 120);
  check "a square" square (20, 20, 216);
  check "at the top" (square ^ " preserveAspectRatio='xMidYMin'") (20, 20, 168);
  check "at the bottom" (square ^ " preserveAspectRatio='xMaxYMax meet'") (20, 20, 168);
  check "in other units" (wide ^ " width='1in' height='96'") (20, 20, 216);
  check "longer" (wide ^ " width='40' height='10' preserveAspectRatio='xMinYMid'") (20, 5, 30)

let clips () =
  let clip inner = Printf.sprintf "<clipPath id='c'>%s</clipPath>" inner in
  area "clip" (clip "<circle cx='20' cy='15' r='5'/>" ^ "<rect width='40' height='15' clip-path='url(#c)'/>")
    (both (circle 20. 15. 5.) (fun _ y -> y -. 15.));
  let two = clip "<rect width='10' height='30'/><rect x='30' width='5' height='30'/>" in
  area "a clip of two" (two ^ "<rect y='10' width='40' height='5' clip-path='url(#c)'/>")
    (union (box 0. 10. 10. 15.) (box 30. 10. 35. 15.));
  area "a clip of a group, in its place"
    (clip "<circle r='5'/>" ^ "<g transform='translate(20 15)' clip-path='url(#c)'><rect x='-20' y='-15' \
                               width='40' height='30'/></g>")
    (circle 20. 15. 5.);
  area "clips in clips"
    ("<clipPath id='d'><rect width='20' height='30'/></clipPath><clipPath id='c' clip-path='url(#d)'><circle \
      cx='20' cy='15' r='5'/></clipPath>"
     ^ "<rect width='40' height='30' clip-path='url(#c)'/>")
    (both (circle 20. 15. 5.) (fun x _ -> x -. 20.));
  let everything = "<rect width='40' height='30' clip-path='url(#c)'/>" in
  area "clip-rule" (clip "<path clip-rule='evenodd' d='M0 0h30v20h-30zM5 5h10v10h-10z'/>" ^ everything)
    (without (box 0. 0. 30. 20.) (box 5. 5. 15. 15.));
  area "a clip of a stroke"
    (clip "<rect width='20' height='30'/>" ^ "<path stroke='red' stroke-width='4' clip-path='url(#c)' d='M10 \
                                              10H30'/>") (box 10. 8. 20. 12.)

(* {1 Styles} *)

let colours () =
  let is name expected body =
    let r = ok ~resolution:1 name (svg ~box:"0 0 1 1" body) in
    let found = if inside r 0 0 then Raster.colour_text r.colours.(0) else "none" in
    Alcotest.(check string) name expected found
  in
  let fill expected value = is value expected (Printf.sprintf "<rect fill='%s' width='1' height='1'/>" value) in
  fill "#663399" "RebeccaPurple"; fill "#ffefd5" "papayawhip"; fill "#778899" "lightslategrey"; fill "#aabbcc"
    "#abc";
  fill "#aabbcc" "#abcf"; fill "none" "#abc4"; fill "#0a0b0c" "#0A0B0Cff"; fill "none" "#0a0b0c7f"; fill
    "#0a0b0c" "#0a0b0c80";
  fill "#ff8000" "rgb(255, 128, 0)"; fill "#ff8000" "rgb(100% 50.2% 0% / 100%)"; fill "none" "rgba(1,2,3,.49)";
  fill "#ff0000" "rgb(300,-5,0)"; fill "#008000" "hsl(120, 100%, 25.1%)"; fill "#bf4040" "hsl(0 50% 50%)";
  fill "#0000ff" "hsl(240deg 100% 50% / .5)"; fill "#ff0000" "hsl(1turn,100%,50%)"; fill "#00ff00"
    "hsla(-240,100%,50%,1)";
  fill "none" "transparent"; fill "none" "none"; fill "#000000" "currentColor"; fill "#000000" "initial"; fill
    "#000000" "inherit";
  is "currentColor" "#0000ff" "<g color='blue'><rect fill='currentColor' width='1' height='1'/></g>";
  is "currentColor is inherited as a word" "#ff0000"
    "<g color='blue' fill='currentColor'><rect color='red' width='1' height='1'/></g>";
  is "inherit" "#0000ff" "<g fill='blue'><rect fill='inherit' width='1' height='1'/></g>";
  let gradient = "<linearGradient id='g'><stop stop-color='red'/></linearGradient>" in
  is "a gradient" "#000000" (gradient ^ "<rect fill='url(#g)' width='1' height='1'/>");
  is "a quoted gradient" "#000000" (gradient ^ "<rect style='fill:url(\"#g\")' width='1' height='1'/>");
  is "no gradient, but a colour" "#0000ff" "<rect fill='url(#h) blue' width='1' height='1'/>";
  is "a gradient as a stroke" "#000000" (gradient ^ "<path stroke='url(#g)' d='M0 .5h1v.1'/>");
  is "paint-order" "#000000" "<rect stroke='red' paint-order='stroke' width='1' height='1'/>";
  is "opacity once" "#000000" "<rect opacity='.7' style='opacity:.7' width='1' height='1'/>";
  is "opacity of both" "none" "<g opacity='.7'><rect style='opacity:.7' width='1' height='1'/></g>";
  is "fill-opacity is inherited" "#000000"
    "<g fill-opacity='.7'><rect fill-opacity='.7' width='1' height='1'/></g>"

let sheets () =
  let is name expected sheet body =
    let r = ok ~resolution:1 name (svg ~box:"0 0 1 1" (Printf.sprintf "<style>%s</style>%s" sheet body)) in
    let found = if inside r 0 0 then Raster.colour_text r.colours.(0) else "none" in
    Alcotest.(check string) name expected found
  in
  let rect = "<rect id='i' class='a b' fill='#111111' width='1' height='1'/>" in
  is "names" "#222222" "rect{fill:#222222}" rect;
  is "everything" "#222222" "*{fill:#222222}" rect;
  is "classes" "#222222" ".b{fill:#222222}circle{fill:red}" rect;
  is "ids" "#222222" "#i { fill : #222222 ; }" rect;
  is "together" "#222222" "rect.a.b#i{fill:#222222}rect.c{fill:red}" rect;
  is "lists and comments" "#222222" "/* {} */ circle, .a/**/{fill:#222222;}" rect;
  is "an id counts more than classes" "#222222" "#i{fill:#222222}.a.b{fill:red}" rect;
  is "a class more than names" "#222222" ".a{fill:#222222}svg rect{fill:red}" rect;
  is "later ones more" "#222222" ".a{fill:red}.b{fill:#222222}" rect;
  is "important ones more" "#222222" ".a{fill:#222222 !important}#i{fill:red}" rect;
  is "style counts more" "#333333" "#i{fill:red}" "<rect id='i' style='FILL:#333333' width='1' height='1'/>";
  is "but not than what is important" "#222222" "rect{fill:#222222!important}"
    "<rect style='fill:red' width='1' height='1'/>";
  let nested = Printf.sprintf "<g class='o'><g id='m'>%s</g></g>" rect in
  is "within" "#222222" ".o rect{fill:#222222}" nested;
  is "children" "#111111" ".o > rect{fill:red}" nested;
  is "children of children" "#222222" ".o>#m>rect{fill:#222222}" nested;
  is "within a child" "#222222" "svg > g rect{fill:#222222}" nested;
  is "the root" "#222222" ":root rect{fill:#222222}rect:root{fill:red}" nested;
  is "pointers" "#111111" "rect:hover{fill:red}" rect;
  is "CDATA" "#222222" "<![CDATA[ g > rect{fill:#222222} ]]>" nested;
  is "other rules" "#222222" "@charset 'x'; @font-face{font-family:x} rect{fill:#222222}" rect;
  is "after what it is for" "#222222" "" (rect ^ "<style>.a{fill:#222222}</style>");
  is "used" "#222222" "defs rect{fill:#222222}g rect{fill:red}"
    (Printf.sprintf "<defs>%s</defs><g><use href='#i'/></g>" rect)

(* {1 What is refused} *)

let refused () =
  let is expected name body = Alcotest.(check string) name expected (code (svg body)) in
  let rect more = Printf.sprintf "<rect %s width='9' height='9'/>" more in
  is "SC0340" "a use of itself" "<g id='a'><use href='#a'/></g>";
  is "SC0340" "a use in a use" "<g id='a'><use href='#b'/></g><g id='b'><use href='#a'/></g>";
  is "SC0340" "a use of nothing" "<use href='#a'/>";
  is "read" "a use without a reference" "<use/>";
  is "SC0341" "a use of another file" "<use href='a.svg#a'/>";
  is "SC0340" "a clip of itself"
    ("<clipPath id='c'><rect clip-path='url(#c)' width='9' height='9'/></clipPath>" ^ rect "clip-path='url(#c)'");
  is "SC0340" "no such clip" (rect "clip-path='url(#c)'");
  is "SC0341" "a clip of text" ("<clipPath id='c'><text/></clipPath>" ^ rect "clip-path='url(#c)'");
  is "SC0341" "a clip by a shape of CSS" (rect "clip-path='circle(5px)'");
  is "SC0340" "no such gradient" (rect "fill='url(#g)'");
  is "SC0341" "a pattern" ("<pattern id='g'/>" ^ rect "fill='url(#g)'");
  is "SC0341" "a mask" (rect "mask='url(#m)'");
  is "SC0341" "markers" (rect "marker-end='url(#m)'");
  is "SC0341" "markers of corners, without one at the end"
    "<path marker-mid='url(#m)' marker-end='none' d='M0 0H9V9z'/>";
  is "SC0341" "a colour of the system" (rect "fill='ButtonText'");
  is "SC0341" "a function" (rect "fill='color-mix(in srgb, red, blue)'");
  is "SC0340" "a colour" (rect "fill='#12345'");
  is "SC0340" "a colour of five numbers" (rect "fill='rgb(1,2,3,4,5)'");
  is "SC0340" "a width below 0" (rect "stroke='red' stroke-width='-1'");
  is "SC0340" "a limit below 1" (rect "stroke='red' stroke-miterlimit='.5'");
  is "SC0341" "another join" (rect "stroke='red' stroke-linejoin='arcs'");
  is "SC0340" "a dash below 0" (rect "stroke='red' stroke-dasharray='1 -1'");
  is "SC0341" "a width in pixels" (rect "stroke='red' vector-effect='non-scaling-stroke'");
  is "SC0341" "pathLength with dashes" (rect "stroke='red' stroke-dasharray='1' pathLength='3'");
  is "SC0341" "geometry by CSS" (rect "style='x:3px'");
  let sheet text = Printf.sprintf "<style>%s</style>" text in
  is "SC0341" "attributes" (sheet "rect[x]{fill:red}");
  is "SC0341" "what is beside" (sheet "a + b{fill:red}");
  is "SC0341" "media" (sheet "@media print{a{fill:red}}");
  is "SC0341" "another pseudo-class" (sheet "a:first-child{fill:red}");
  is "SC0341" "another language" "<style type='text/less'></style>";
  is "SC0340" "braces" (sheet "a{fill:red");
  is "SC0340" "no braces" (sheet "a");
  is "SC0340" "no selector" (sheet "{fill:red}");
  is "SC0340" "half a selector" (sheet "a > {fill:red}");
  is "SC0340" "no colon" (sheet "a{fill}");
  is "read" "a comment without its end" (sheet "/* a");
  is "SC0340" "a ratio" "<svg viewBox='0 0 1 1' preserveAspectRatio='middle'/>"

(* Each of these would take years or the memory of a machine. *)
let bombs () =
  let is expected name body = Alcotest.(check string) name expected (code (svg body)) in
  let doubling =
    String.concat ""
      (List.init 60 (fun i -> Printf.sprintf "<g id='a%d'><use href='#a%d'/><use href='#a%d'/></g>" i (i + 1)
                        (i + 1)))
  in
  is "SC0340" "uses that double" (doubling ^ "<g id='a60'/>");
  is "SC0340" "dashes" "<path stroke='red' stroke-dasharray='1e-9' d='M0 0h30'/>";
  is "SC0340" "fine curves" "<path stroke='red' stroke-width='1e6' d='M0 0Q3 900000 9 9'/>";
  is "SC0340" "as deep by uses"
    (String.concat "" (List.init 300 (fun i -> Printf.sprintf "<g id='a%d'><use href='#a%d'/></g>" i (i + 1))) ^
     "<g id='a300'/>");
  is "SC0340" "selectors" (Printf.sprintf "<style>%s</style>" (String.concat "" (List.init 2000 (fun _ -> "a{}"))))

let () =
  let case name f = Alcotest.test_case name `Quick f in
  Alcotest.run "svg"
    [
      ("structure", [ case "references" references; case "viewports" viewports; case "clips" clips ]);
      ("styles", [ case "colours" colours; case "sheets" sheets ]);
      ("refused", [ case "faults" refused; case "bombs" bombs ]);
    ]
