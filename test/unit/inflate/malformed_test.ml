(* SVG: a malformed value is refused, or ignored as in CSS: the picture is that without it. Boxes of what is
   clipped and painted, against formulas. *)
open Scc_base
open Areas

(* {1 Malformed values} *)

let picture body =
  match read ~resolution:40 (svg body) with
  | Ok r -> Ok (Array.to_list r.colours, Bytes.to_string r.alphas)
  | Error d -> Error (d.Diag.code :> string)

let same = Result.equal ~ok:(fun (a, b) (c, d) -> List.equal Int.equal a c && String.equal b d)
    ~error:String.equal

let numbers = [ ".5abc"; "5 5"; "5,"; ",5"; "5,,5"; "5 px"; "5%%"; "5!important"; "--5"; "."; "5/2";
                "0x5" ]

let words =
  [ ""; "abc"; "none none"; "inherit none"; "visible hidden"; "none,"; "hidden;"; "evenodd nonzero"; "round \
                                                                                                      square";
    "fill fill"; "fill abc"; "stroke,fill" ]

let colours =
  [
    "rgb(255,,0,0)"; "rgb(255 0 0 0)"; "rgb(255,0 0,0)"; "rgb(255,0,0/0)"; "rgb(255 0 0 / 0 / 0)";
    "rgba(0,0,0,)";
    "rgb(1,50%,3,0)"; "hsl(1,50,50,0)"; "hsl(1,50%,50%,0deg)"; "rgb (0,0,0,0)"; "rgb(0,0,0,0"; "rgb(0,0,0,0))";
    "#0000ff000"; "#";
    "transparent none"; "none none"; "rgb(0 0 0 0%)"; "rgba(0px,0,0,0)";
  ]

(* Of each property: a value that is seen, and malformed ones. *)
let properties =
  let numbers_and more = numbers @ words @ more in
  [
    ("opacity", "0", numbers_and []); ("fill-opacity", "0", numbers_and []);
    ("stroke-opacity", "0", numbers_and []);
    ("fill", "none", numbers @ words @ colours); ("stroke", "lime", numbers @ words @ colours);
    ("color", "transparent", "none" :: (numbers @ words @ colours));
    ("fill-rule", "evenodd", numbers_and [ "even-odd" ]);
    ("visibility", "hidden", numbers_and [ "none"; "visibl" ]); ("display", "none", numbers_and [ "hidden" ]);
    ("stroke-width", "3", numbers_and [ "1q5" ]); ("stroke-linecap", "square", numbers_and []);
    ("stroke-linejoin", "bevel", numbers_and []); ("stroke-miterlimit", "1", numbers_and [ "0"; "5px" ]);
    ("stroke-dasharray", "2", [ ".5abc"; "5,"; ",5"; "5,,5"; "abc"; "none none"; "5/2"; "5 a" ]);
    ("stroke-dashoffset", "1", numbers_and []); ("paint-order", "stroke", numbers_and []);
    ("clip-path", "url(#c)", numbers_and [ "url(#c"; "url(#c) none"; "url(#c) abc" ]);
    ("transform", "translate(3,0)",
     [ "translate(3,,0)"; "translate(3"; "translate(,3)"; "translate(3,)"; "translate(3) abc"; "turn(3)";
       "scale()";
       "translate(3),,scale(2)"; ",scale(2)"; "scale(2),"; "translate(3abc)"; "rotate(1 2)"; "matrix(1 0 0 1 \
                                                                                              0)" ]);
    ("transform-origin", "9px 9px",
     [ "left left"; "top top"; "top 5px"; "5px,5px"; "5 px"; "5px 5px 5px 5px"; "left 5abc" ]);
  ]

(* What each of them changes: a square with a hole, turned, and a dashed line. *)
let shapes =
  [
    [ ("d", "M5 5h20v20h-20zM9 9h9v9h-9z"); ("fill", "currentColor"); ("stroke", "red"); ("stroke-width", "4");
      ("transform", "scale(.9)") ];
    [ ("d", "M30 5l5 20l-2 -15"); ("fill", "none"); ("stroke", "blue"); ("stroke-width", "2");
      ("stroke-dasharray", "5 2") ];
  ]

let drawn change =
  let written (name, value) = Printf.sprintf "%s='%s'" name value in
  let path attributes = Printf.sprintf "<path %s/>" (String.concat " " (List.map written (change attributes))) in
  "<clipPath id='c'><rect width='12' height='30'/></clipPath><g color='#123456'>"
  ^ String.concat "" (List.map path shapes) ^ "</g>"

let malformed (name, good, values) () =
  let plain = picture (drawn (List.remove_assoc name)) in
  let set value attributes = (name, value) :: List.remove_assoc name attributes in
  let style text attributes = ("style", text) :: attributes in
  let declared value = Printf.sprintf "%s:%s" name value in
  let css = if name = "transform" then "translate(3px,0)" else good in
  let styled = picture (drawn (style (declared css))) in
  Alcotest.(check bool) (name ^ " is seen") false (same plain (picture (drawn (set good))));
  Alcotest.(check bool) (name ^ " is seen in a style") false (same (picture (drawn Fun.id)) styled);
  let check value =
    let is how expected found =
      Alcotest.(check bool) (declared value ^ how) true (Result.is_error found || same expected found)
    in
    is "" plain (picture (drawn (set value)));
    if not (String.contains value '!') then
      is " in a style" styled (picture (drawn (style (declared css ^ ";" ^ declared value))))
  in
  List.iter check values

(* {1 Boxes} *)

(* Below the curve from (10, 5) to (30, 5) with the controls (10, 15) and (30, 15), by bisection. *)
let under x y =
  let at t = 10. +. (60. *. t *. t) -. (40. *. t *. t *. t) in
  let rec go n low high =
    let t = (low +. high) /. 2. in
    if n = 0 then t else if at t <= x then go (n - 1) t high else go (n - 1) low t
  in
  let t = go 40 0. 1. in
  Float.max (5. -. y) (y -. 5. -. (30. *. t *. (1. -. t)))

let boxes () =
  let clip ?(more = "") inner =
    Printf.sprintf "<clipPath id='c' clipPathUnits='objectBoundingBox' %s>%s</clipPath>" more inner
  in
  let half = clip "<rect width='.5' height='1'/>" in
  let is name body expected = area name (half ^ body) expected in
  is "a rectangle" "<rect x='10' y='5' width='20' height='10' clip-path='url(#c)'/>" (box 10. 5. 20. 15.);
  is "a stroke is clipped by the box of its line"
    "<path d='M10 10L30 20' fill='none' stroke='red' stroke-width='100' clip-path='url(#c)'/>" (box 10. 10.
                                                                                                  20. 20.);
  is "its own transform" "<rect transform='translate(10 5) scale(2)' width='10' height='5' clip-path='url(#c)'/>"
    (box 10. 5. 20. 15.);
  is "a group" "<g clip-path='url(#c)'><rect x='4' y='4' width='4' height='4'/><g transform='translate(20 \
                0)'><rect \
                y='10' width='8' height='4'/></g></g>" (box 4. 4. 8. 8.);
  is "what is not displayed does not count, and what is hidden does"
    "<g clip-path='url(#c)'><rect x='4' y='4' width='16' height='4'/><rect display='none' width='90' height='1'/>\
     <rect x='4' y='20' width='24' height='1' visibility='hidden'/><g display='none'><rect width='90' \
     height='9'/></g></g>"
    (box 4. 4. 16. 8.);
  is "what is clipped counts"
    "<clipPath id='d'><rect width='5' height='30'/></clipPath><g clip-path='url(#c)'><rect clip-path='url(#d)' \
     width='8' height='30'/></g>" (box 0. 0. 4. 30.);
  is "a use" "<defs><rect id='r' x='4' width='8' height='8'/></defs><use href='#r' x='10' y='6' \
              clip-path='url(#c)'/>"
    (box 14. 6. 18. 14.);
  is "a symbol" "<symbol id='s' viewBox='0 0 10 10' clip-path='url(#c)'><rect width='8' \
                 height='10'/></symbol><use \
                 href='#s' width='20' height='20'/>" (box 0. 0. 8. 20.);
  is "an inner drawing" "<svg x='10' y='5' width='20' height='10' viewBox='0 0 4 2' clip-path='url(#c)'><rect \
                         width='2' height='2'/></svg>" (box 10. 5. 15. 15.);
  is "a curve" "<path d='M10 5C10 15 30 15 30 5' clip-path='url(#c)'/>"
    (both (box 0. 0. 20. 30.) under);
  is "a circle" "<circle cx='20' cy='15' r='10' clip-path='url(#c)'/>" (both (circle 20. 15. 10.) (fun x _ ->
      x -. 20.));
  is "a turned ellipse" "<g transform='rotate(90 20 15)'><ellipse cx='20' cy='15' rx='6' ry='6' \
                         clip-path='url(#c)'/></g>" (both (circle 20. 15. 6.) (fun _ y -> y -. 15.));
  is "nothing at all" "<g clip-path='url(#c)'/><rect width='9' height='9'/>" (box 0. 0. 9. 9.);
  is "scaled to nothing" "<rect transform='scale(0)' width='9' height='9' clip-path='url(#c)'/><rect width='9' \
                          height='9'/>" (box 0. 0. 9. 9.);
  is "a clip path in its units, of a shape in another one"
    "<clipPath id='d'><rect width='20' height='30' clip-path='url(#c)'/></clipPath><rect width='40' height='30' \
     clip-path='url(#d)'/>" (box 0. 0. 10. 30.);
  area "the transform of the clip path is around its units"
    (clip ~more:"transform='translate(5 0)'" "<rect width='.5' height='1'/>"
     ^ "<rect width='40' height='30' clip-path='url(#c)'/>") (box 5. 0. 25. 30.);
  let is expected name body = Alcotest.(check string) name expected (code (svg (half ^ body))) in
  is "SC0341" "a line" "<path d='M0 5h9' stroke='red' clip-path='url(#c)'/>";
  is "SC0341" "a clip path" "<clipPath id='d' clip-path='url(#c)'/><rect width='9' height='9' \
                             clip-path='url(#d)'/>";
  Alcotest.(check string) "other units" "SC0340"
    (code (svg "<clipPath id='c' clipPathUnits='pixels'/><rect clip-path='url(#c)' width='9' height='9'/>"));
  Alcotest.(check string) "the whole drawing" "SC0341"
    (code (Printf.sprintf "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9' \
                           clip-path='url(#c)'>%s<rect \
                           width='9' height='9'/></svg>" half))

let gradients () =
  let gradient ?(kind = "linear") more =
    Printf.sprintf "<%sGradient id='g' %s><stop/><stop offset='1'/></%sGradient>" kind more kind
  in
  let square = "<rect width='9' height='9'/>" and line = "<path d='M0 20h40' stroke-width='4' \
                                                          stroke='url(#g)'/>" in
  let both = union (box 0. 0. 9. 9.) (box 0. 18. 40. 22.) in
  area "a line has no height" (gradient "" ^ square ^ line) (box 0. 0. 9. 9.);
  area "a line, and another paint" (gradient "" ^ square ^ "<path d='M0 20h40' stroke-width='4' \
                                                            stroke='url(#g) red'/>")
    both;
  area "a line, in units of the drawing" (gradient "gradientUnits='userSpaceOnUse'" ^ square ^ line) both;
  area "units of another gradient"
    ("<linearGradient id='h' gradientUnits='userSpaceOnUse'/>" ^ gradient "href='#h'" ^ square ^ line) both;
  area "a focus within its circle" (gradient ~kind:"radial" "fx='.8' fy='.7'" ^ "<rect fill='url(#g)' width='9' \
                                                                                 height='9'/>") (box 0. 0. 9. 9.);
  let rect = "<rect fill='url(#g)' width='9' height='9'/>" in
  let is expected name more = Alcotest.(check string) name expected (code (svg (gradient ~kind:"radial" more ^
                                                                                rect))) in
  is "SC0341" "a focus on its circle" "fx='.8' fy='.9'";
  is "SC0341" "a focus beyond its circle" "fx='1.2'";
  is "SC0341" "a focus as large as its circle" "fr='50%'";
  is "SC0341" "a focus larger than its circle" "fr='60%'";
  is "read" "a focus in units of the drawing" "gradientUnits='userSpaceOnUse' cx='10' cy='10' r='5' fx='12' \
                                               fy='13'";
  is "SC0341" "a focus beyond, in units of the drawing" "gradientUnits='userSpaceOnUse' cx='10' cy='10' r='5' \
                                                         fx='16'";
  is "SC0340" "a radius below 0" "r='-1'";
  is "SC0341" "scaled to nothing" "gradientTransform='scale(0)'";
  is "SC0340" "a transform that is none" "gradientTransform='big'";
  is "SC0340" "units that are none" "gradientUnits='pixels'";
  Alcotest.(check string) "a stop that is not" "SC0340"
    (code (svg ("<linearGradient id='g'><stop stop-opacity='.5x'/></linearGradient>" ^ rect)))

(* {1 Places} *)

let places () =
  let is name expected body =
    let text = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9'>\n" ^ body ^ "</svg>" in
    match read ~resolution:8 text with
    | Ok _ -> Alcotest.fail name
    | Error d -> Alcotest.(check string) name expected (String.sub text d.span.start (d.span.stop -
                                                                                      d.span.start))
  in
  is "a shape" "<rect" "<g><rect opacity='x' width='9' height='9'/></g>";
  is "a group" "<g" "<g opacity='x'><rect/></g>";
  is "an empty element beside another" "<path" "<path d='M0 0x'/><rect/>";
  is "an element that is refused" "<text" "<g><text>a</text></g>";
  is "a stop" "<stop" "<linearGradient id='g'><stop stop-opacity='x'/><stop/></linearGradient><rect \
                       fill='url(#g)' \
                       width='9' height='9'/>";
  is "a gradient" "<radialGradient"
    "<radialGradient id='g' r='-1'><stop/></radialGradient><rect fill='url(#g)' width='9' height='9'/>";
  is "a sheet" "<style" "<style>a{</style><g/>";
  is "letters of two bytes" "<rect" "<g id='\xc3\xa9\xc3\xa9'><rect opacity='x' width='9' height='9'/></g>"

(* By XML, an attribute is there once, and nothing but comments follows the root. *)
let well_formed () =
  let is expected text =
    let found = match read ~resolution:8 text with Ok _ -> "read" | Error d -> (d.Diag.code :> string) in
    Alcotest.(check string) text expected found
  in
  let drawn root rect =
    "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9'" ^ root ^ "><rect width='9' height='9'" ^ rect
    ^ "/></svg>"
  in
  let drawing = drawn "" "" in
  is "read" drawing;
  is "read" (drawing ^ "\n<!-- the end --> ");
  List.iter (fun after -> is "SC0340" (drawing ^ after)) [ "junk"; "<rect/>"; drawing ];
  is "SC0340" (drawn "" " width='1'");
  is "SC0340" (drawn " viewBox='0 0 1 1'" "")

let () =
  let case name f = Alcotest.test_case name `Quick f in
  Alcotest.run "malformed"
    [
      ("values", List.map (fun ((name, _, _) as property) -> case name (malformed property)) properties);
      ("boxes", [ case "clip paths" boxes; case "gradients" gradients ]); ("places", [ case "tags" places ]);
      ("XML", [ case "well formed" well_formed ]);
    ]
