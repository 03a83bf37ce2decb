(* SVG: strokes against formulas of distance, references, clips, style sheets, colours, and what is refused. *)
open Scc_base
open Scc_pixels
module G = QCheck2.Gen

let read ?(resolution = 160) text = Icon.read ~resolution ~path:"icon" text

let ok ?resolution name text =
  match read ?resolution text with
  | Ok r -> r
  | Error d -> Alcotest.failf "%s: %s" name d.Diag.message

let code text = match read ~resolution:16 text with Ok _ -> "read" | Error d -> (d.code :> string)

let svg ?(box = "0 0 40 30") body =
  Printf.sprintf
    "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" \
     viewBox=\"%s\">%s</svg>" box body

let inside (r : Raster.t) x y = Bytes.get_uint8 r.alphas ((y * r.width) + x) <> 0

(* {1 Areas} *)

(* [value x y], less than 0 inside, has at most the slope 1: centres nearer than 1/32 pixel to the line may be on
   either side. Four pixels are one unit. *)
let area name body value =
  let r = ok name (svg body) in
  Alcotest.(check (pair int int)) name (160, 120) (r.width, r.height);
  for y = 0 to 119 do
    for x = 0 to 159 do
      let v = 4. *. value ((float_of_int x +. 0.5) /. 4.) ((float_of_int y +. 0.5) /. 4.) in
      if Float.abs v > 1. /. 32. && inside r x y <> (v < 0.) then Alcotest.failf "%s: pixel %d, %d" name x y
    done
  done

let circle x0 y0 r x y = Float.hypot (x -. x0) (y -. y0) -. r
let box x0 y0 x1 y1 x y = Float.max (Float.max (x0 -. x) (x -. x1)) (Float.max (y0 -. y) (y -. y1))
let union f g x y = Float.min (f x y) (g x y)
let both f g x y = Float.max (f x y) (g x y)
let without f g x y = Float.max (f x y) (-.g x y)
let any = List.fold_left union (fun _ _ -> infinity)
let ring x0 y0 r half x y = Float.abs (circle x0 y0 r x y) -. half

(* Around a segment: with flat ends, and with round ones. *)
let frame (ax, ay) (bx, by) x y =
  let dx = bx -. ax and dy = by -. ay in
  let l = Float.hypot dx dy in
  (((x -. ax) *. dx) +. ((y -. ay) *. dy)) /. l, (((y -. ay) *. dx) -. ((x -. ax) *. dy)) /. l, l

let bar a b half x y =
  let along, across, l = frame a b x y in
  Float.max (Float.max (-.along) (along -. l)) (Float.abs across -. half)

let capsule a b half x y =
  let along, across, l = frame a b x y in
  Float.hypot (Float.max 0. (Float.max (-.along) (along -. l))) across -. half

(* The half plane to the left of a directed line, as the screen has it: to the right. *)
let beside a b x y =
  let _, across, _ = frame a b x y in
  -.across

let polygon corners =
  let n = List.length corners in
  let edges = List.mapi (fun i a -> beside a (List.nth corners ((i + 1) mod n))) corners in
  List.fold_left both (fun _ _ -> neg_infinity) edges

let pen = "fill='none' stroke='red' stroke-width='4'"
let path ?(more = "") d = Printf.sprintf "<path %s %s d='%s'/>" pen more d

let caps () =
  let line more = path ~more "M10 10L25 18" in
  let a = (10., 10.) and b = (25., 18.) in
  area "butt" (line "") (bar a b 2.);
  area "round" (line "stroke-linecap='round'") (capsule a b 2.);
  let dx = 2. *. 15. /. 17. and dy = 2. *. 8. /. 17. in
  area "square" (line "stroke-linecap='square'") (bar (10. -. dx, 10. -. dy) (25. +. dx, 18. +. dy) 2.);
  area "a line" (Printf.sprintf "<line %s x1='10' y1='10' x2='25' y2='18'/>" pen) (bar a b 2.);
  area "no length, round" (path ~more:"stroke-linecap='round'" "M10 10z") (circle 10. 10. 2.);
  area "no length, square" (path ~more:"stroke-linecap='square'" "M10 10h0") (box 8. 8. 12. 12.);
  area "no length, butt" (path "M10 10h0M20 20h1" ) (box 20. 18. 21. 22.);
  area "a move alone" (path ~more:"stroke-linecap='round'" "M10 10M20 20h1") (capsule (20., 20.) (21., 20.) 2.)

let joins () =
  let corner more = path ~more "M10 25V10H30" in
  let arms = union (box 8. 10. 12. 25.) (box 10. 8. 30. 12.) in
  area "miter" (corner "") (union arms (box 8. 8. 12. 12.));
  area "round join" (corner "stroke-linejoin='round'") (union arms (circle 10. 10. 2.));
  area "bevel" (corner "stroke-linejoin='bevel'")
    (union arms (polygon [ (10., 8.); (10., 10.); (8., 10.) ]));
  (* 1/sin(45 degrees) = 1.414. *)
  area "within the limit" (corner "stroke-miterlimit='1.415'") (union arms (box 8. 8. 12. 12.));
  area "beyond the limit" (corner "stroke-miterlimit='1.414'")
    (union arms (polygon [ (10., 8.); (10., 10.); (8., 10.) ]));
  area "the other way" (path "M30 10H10V25") (union arms (box 8. 8. 12. 12.));
  let sides = without (box 8. 8. 32. 22.) (box 12. 12. 28. 18.) in
  area "closed" (path "M10 10h20v10h-20z") sides;
  area "closed by the last line too" (path "M10 10h20v10h-20v-10z") sides;
  area "rect" (Printf.sprintf "<rect %s x='10' y='10' width='20' height='10'/>" pen) sides;
  area "polygon" (Printf.sprintf "<polygon %s points='10 10 30 10 30 20 10 20'/>" pen) sides;
  area "polyline" (Printf.sprintf "<polyline %s points='10 25 10 10 30 10'/>" pen)
    (union arms (box 8. 8. 12. 12.));
  area "fill and stroke" "<rect stroke='red' stroke-width='4' x='10' y='10' width='20' height='10'/>"
    (box 8. 8. 32. 22.);
  area "back on itself, round" (path ~more:"stroke-linejoin='round'" "M10 10h10h-10")
    (union (box 10. 8. 20. 12.) (circle 20. 10. 2.));
  area "back on itself, miter" (path "M10 10h10h-10") (box 10. 8. 20. 12.)

let curves () =
  area "circle" (Printf.sprintf "<circle %s cx='20' cy='15' r='10'/>" pen) (ring 20. 15. 10. 2.);
  area "a pen wider than the circle" "<circle fill='none' stroke='red' stroke-width='8' cx='20' cy='15' r='3'/>"
    (circle 20. 15. 7.);
  area "half a circle" (path "M10 15A10 10 0 0 1 30 15") (both (ring 20. 15. 10. 2.) (fun _ y -> y -. 15.));
  area "a quarter" (path "M20 5A10 10 0 0 1 30 15")
    (both (ring 20. 15. 10. 2.) (both (fun _ y -> y -. 15.) (fun x _ -> 20. -. x)));
  let round = "stroke-linecap='round'" in
  area "with round ends" (path ~more:round "M10 15A10 10 0 0 1 30 15")
    (any [ both (ring 20. 15. 10. 2.) (fun _ y -> y -. 15.); circle 10. 15. 2.; circle 30. 15. 2. ]);
  (* Straight lines as curves. *)
  area "a straight cubic" (path "M10 10C15 12.6666666667 20 15.3333333333 25 18") (bar (10., 10.) (25., 18.) 2.);
  area "a curve that waits" (path "M10 10C10 10 25 18 25 18") (bar (10., 10.) (25., 18.) 2.);
  area "scaled" "<g transform='translate(20 15) scale(2)'><circle fill='none' stroke='red' stroke-width='2' \
                 r='5'/></g>"
    (ring 0. 0. 10. 2. |> fun f x y -> f (x -. 20.) (y -. 15.));
  (* A circle of radius 1 with a pen of width 1, four times as wide as high: an ellipse without a smaller one. *)
  let stretched x y =
    let u = (x -. 20.) /. 8. and v = (y -. 15.) /. 2. in
    let h = Float.hypot u v in
    (* The distance is about the value over the length of its gradient. *)
    if h = 0. then 1. else
      let slope = Float.hypot (u /. h /. 8.) (v /. h /. 2.) in
      (Float.abs (h -. 1.) -. 0.5) /. slope /. 2.
  in
  area "stretched" "<g transform='translate(20 15) scale(8 2)'><circle fill='none' stroke='red' r='1'/></g>"
    stretched

let dashes () =
  let dashed ?(more = "") lengths d = path ~more:(Printf.sprintf "stroke-dasharray='%s' %s" lengths more) d in
  area "dashes" (dashed "4 2" "M5 10h20")
    (any [ box 5. 8. 9. 12.; box 11. 8. 15. 12.; box 17. 8. 21. 12.; box 23. 8. 25. 12. ]);
  area "an odd number" (dashed "5" "M5 10h20") (any [ box 5. 8. 10. 12.; box 15. 8. 20. 12. ]);
  area "an offset" (dashed ~more:"stroke-dashoffset='3'" "4 2" "M5 10h8")
    (any [ box 5. 8. 6. 12.; box 8. 8. 12. 12. ]);
  area "an offset back" (dashed ~more:"stroke-dashoffset='-1'" "4 2" "M5 10h8")
    (union (box 6. 8. 10. 12.) (box 12. 8. 13. 12.));
  area "around a corner" (dashed "14 100" "M5 10h10v20") (any [ box 5. 8. 17. 12.; box 13. 8. 17. 14. ]);
  area "dots" (dashed ~more:"stroke-linecap='round'" "0 8" "M5 10h18")
    (any [ circle 5. 10. 2.; circle 13. 10. 2.; circle 21. 10. 2. ]);
  area "all lengths 0" (dashed "0 0" "M5 10h20") (box 5. 8. 25. 12.);
  (* The last dash goes on where the line began: no caps there, but a join. *)
  area "closed" (dashed ~more:"stroke-dashoffset='5'" "10 10" "M10 10h20v10h-20z")
    (any [ box 8. 8. 15. 12.; box 8. 8. 12. 15.; box 25. 8. 32. 12.; box 28. 8. 32. 15.; box 15. 18. 25. 22. ]);
  area "a ring of one dash" (dashed "100 1" "M10 10h20v10h-20z")
    (without (box 8. 8. 32. 22.) (box 12. 12. 28. 18.));
  (* A quarter of a circle is drawn, the next one not. *)
  let quarters x y = -.((x -. 20.) *. (y -. 15.)) /. Float.hypot (x -. 20.) (y -. 15.) in
  area "on a circle"
    (Printf.sprintf "<circle %s stroke-dasharray='%.9f' cx='20' cy='15' r='10'/>" pen (Float.pi *. 5.))
    (both (ring 20. 15. 10. 2.) quarters)

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
    (clip "<rect width='20' height='30'/>" ^ path ~more:"clip-path='url(#c)'" "M10 10H30") (box 10. 8. 20. 12.)

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
  is "a gradient as a stroke" "#000000" (gradient ^ "<path stroke='url(#g)' d='M0 .5h1'/>");
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
  is "SC0341" "a clip in other units"
    ("<clipPath id='c' clipPathUnits='objectBoundingBox'/>" ^ rect "clip-path='url(#c)'");
  is "SC0341" "a clip by a shape of CSS" (rect "clip-path='circle(5px)'");
  is "SC0340" "no such gradient" (rect "fill='url(#g)'");
  is "SC0341" "a pattern" ("<pattern id='g'/>" ^ rect "fill='url(#g)'");
  is "SC0341" "a mask" (rect "mask='url(#m)'");
  is "SC0341" "markers" (rect "marker-end='url(#m)'");
  is "SC0341" "a colour of the system" (rect "fill='ButtonText'");
  is "SC0341" "a function" (rect "fill='lab(1 2 3)'");
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
  is "SC0340" "a comment" (sheet "/* a");
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

(* {1 Random things} *)

(* A stroke of segments with round caps and joins is what is near to them. *)
let round_strokes =
  let open G in
  let coordinate = int_range 4 36 in
  let* corners = list_size (int_range 2 6) (pair coordinate (int_range 4 26)) and* width = int_range 1 6 and*
    closed = bool in
  return (corners, width, closed)

let show (corners, width, closed) =
  let d = String.concat " L" (List.map (fun (x, y) -> Printf.sprintf "%d %d" x y) corners) in
  Printf.sprintf "<path fill='none' stroke='red' stroke-linecap='round' stroke-linejoin='round' \
                  stroke-width='%d' d='M%s%s'/>" width d (if closed then "Z" else "")

let near_segments ((corners, width, closed) as drawn) =
  let point (x, y) = (float_of_int x, float_of_int y) in
  let rec pairs = function
    | a :: (b :: _ as rest) -> (a, b) :: pairs rest
    | [ last ] -> if closed then [ (last, List.hd corners) ] else []
    | [] -> []
  in
  let half = float_of_int width /. 2. in
  let one (a, b) = if a = b then circle (fst (point a)) (snd (point a)) half else capsule (point a) (point b)
        half in
  area "random" (show drawn) (any (List.map one (pairs corners)));
  true

(* All strokes of a line lie within that with round ends and joins grown by the miter limit; and a bevel within
   the miter. *)
let nested_joins (corners, width, closed) =
  let drawn join =
    let d = String.concat " L" (List.map (fun (x, y) -> Printf.sprintf "%d %d" x y) corners) in
    ok "joins" (svg (Printf.sprintf "<path fill='none' stroke='red' stroke-linejoin='%s' stroke-width='%d' \
                                     d='M%s%s'/>" join width d (if closed then "Z" else "")))
  in
  let bevel = drawn "bevel" and round = drawn "round" and miter = drawn "miter" in
  let within (a : Raster.t) (b : Raster.t) =
    let painted (r : Raster.t) i = Bytes.get r.alphas i <> '\000' in
    List.for_all (fun i -> (not (painted a i)) || painted b i) (List.init (Bytes.length a.alphas) Fun.id)
  in
  within bevel round && within bevel miter

let () =
  let case name f = Alcotest.test_case name `Quick f in
  let property name count law =
    Scc_test_support.Property.case (QCheck2.Test.make ~name ~count ~print:show round_strokes law) in
  Alcotest.run "svg"
    [
      ("strokes", [ case "caps" caps; case "joins" joins; case "curves" curves; case "dashes" dashes ]);
      ("structure", [ case "references" references; case "clips" clips ]);
      ("styles", [ case "colours" colours; case "sheets" sheets ]);
      ("refused", [ case "faults" refused; case "bombs" bombs ]);
      ("random", [ property "near to segments" 60 near_segments; property "bevels are within round joins and \
                                                                           miters" 60 nested_joins ]);
    ]
