(* What programs write that is allowed and rare: each kind with what is drawn, or the code of its refusal. *)
open Scc_base
open Areas

(* The halves of a drawing: "left", "right", "both" or "none", or a code. *)
let seen body =
  match read ~resolution:20 (svg ~box:"0 0 20 10" body) with
  | Error d -> (d.Diag.code :> string)
  | Ok r -> (
      match (inside r 5 5, inside r 15 5) with
      | true, false -> "left"
      | false, true -> "right"
      | true, true -> "both"
      | false, false -> "none")

let check (expected, body) = Alcotest.(check string) body expected (seen body)
let left more = Printf.sprintf "<rect %s width='10' height='10'/>" more
let right more = Printf.sprintf "<rect %s x='10' width='10' height='10'/>" more
let switch inner = Printf.sprintf "<switch>%s</switch>" inner

let switches () =
  let adobe = "requiredExtensions='http://ns.adobe.com/AdobeIllustrator/10.0/'" in
  let feature name = Printf.sprintf "requiredFeatures='http://www.w3.org/TR/SVG11/feature#%s'" name in
  List.iter check
    [
      ("right", switch ("<foreignObject " ^ adobe ^ " x='0' width='1'/><g>" ^ right "" ^ "</g>"));
      ("left", switch (left "" ^ right "")); ("right", switch (left adobe ^ right ""));
      ("none", switch (left adobe));
      ("left", switch (left (feature "Shape") ^ right "")); ("none", switch "");
      ("right", switch (left (adobe ^ " systemLanguage='en'") ^ right ""));
      ("right", switch ("<title>t</title><desc/>" ^ right ""));
      ("both", left "" ^ switch (right ""));
      ("none", "<g display='none'>" ^ switch (left "") ^ "</g>");
      ("left", "<switch opacity='.6'>" ^ left "" ^ "</switch>");
      ("SC0341", switch (left "systemLanguage='en'" ^ right ""));
      ("SC0341", switch (left "requiredFeatures='mine'" ^ right ""));
      ("SC0341", switch (left "requiredExtensions=''" ^ right ""));
      ("left", switch (left "" ^ right "systemLanguage='en'"));
      ("SC0341", switch ("<foreignObject width='9' height='9'/>" ^ right ""));
      ("SC0341", switch ("<nonsense/>" ^ right "")); ("SC0341", left adobe);
      ( "left",
        "<clipPath id='c' clipPathUnits='objectBoundingBox'><rect width='.5' height='1'/></clipPath><switch \
         clip-path='url(#c)'><rect width='20' height='10'/></switch>" );
    ]

let texts () =
  List.iter check
    [
      ("left", left "" ^ "<text/>"); ("left", left "" ^ "<text x='3'> \n<tspan/></text>");
      ("SC0341", left "" ^ "<text>a</text>"); ("SC0341", left "" ^ "<text><tspan>a</tspan></text>");
      ("SC0341", left "" ^ "<text><textPath href='#a'/></text>"); ("SC0341", left "" ^ "<tspan/>");
    ]

let inner ratio =
  Printf.sprintf "<svg viewBox='0 0 20 10' width='20' height='10' preserveAspectRatio='%s'>%s</svg>" ratio
    (left "")

let numbers () =
  List.iter check
    [
      ("left", "<rect width='10.' height='10.'/>"); ("left", "<rect width='10.px' height='+10.'/>");
      ("left", inner "defer xMidYMid");
      ("left", inner "defer none meet");
      ("SC0340", inner "defer");
      ("right", right "opacity='1.'"); ("left", "<path stroke='red' stroke-width='10.' d='M0 5H10.'/>");
      ("SC0340", "<rect width='.' height='10'/>"); ("SC0340", "<rect width='10..' height='10'/>");
      ("SC0340", left "style='opacity:1.'"); ("SC0340", "<style>rect{stroke-width:1.px}</style>" ^ left "");
    ]

(* Of each block the last value that is valid; what is not read is never passed over. *)
let blocks () =
  let paint expected block =
    check (expected, left (Printf.sprintf "style='%s'" block));
    check (expected, Printf.sprintf "<style>rect{%s}</style>%s" block (left ""))
  in
  let drawn = paint "left" and none = paint "none" and unread = paint "SC0341" and bad = paint "SC0340" in
  none "fill:none;fill:bogus"; none "fill:none;fill:"; none "fill:none;FILL:#12345;fill:Bogus"; none
    "fill:bogus;fill:none";
  drawn "fill:black;fill:color(display-p3 0 0 0)"; none "visibility:hidden;visibility:bogus"; none
    "opacity:0;opacity:bogus";
  none "fill:none;stroke:red;stroke-width:0;stroke-width:bogus"; none "fill:none!important;fill:bogus";
  (* Each has a value that CSS ignores. *)
  List.iter (fun value -> none ("fill:none;fill:" ^ value))
    [
      "rgb(1,2)"; "rgb(10%,20,30%)"; "rgb(1 2 3 4)"; "rgb(1,2,3/1)"; "rgb(none,0,0)"; "rgb(1 2 3) x";
      "hsl(120,50,50)";
      "hsl(1px 1% 1%)"; "hwb(120,10%,10%)"; "hwb(120 10%)"; "lab(1,2,3)"; "lch(1 2 3%)"; "oklab(1 2)";
      "color(foo 1 0 0)"; "color(srgb 1 0)"; "color(srgb,1,0,0)"; "red blue"; "12"; "red !ie";
    ];
  List.iter none
    [
      "opacity:0;opacity:.5."; "opacity:0;opacity:1."; "opacity:0;opacity:1 1"; "opacity:0;opacity:5px";
      "fill:none;stroke:red;stroke-width:0;stroke-width:-3"; "fill:none;stroke:red;stroke-width:0;stroke-width:1x";
      "display:none;display:inlin"; "display:none;display:5"; "visibility:hidden;visibility:visible hidden";
      "transform:scale(0);transform:rotate(30)"; "transform:scale(0);transform:none none";
    ];
  (* And these have one that may have a meaning, or has one for sure. *)
  List.iter (fun value -> unread ("fill:none;fill:" ^ value))
    [
      "rgb(calc(1) 2 3)"; "rgb(from red r g b)"; "rgb(var(--a))"; "color-mix(in srgb, red, blue)"; "-moz-red";
      "rgb(1e99 2 3)"; "color(xyz 0 0 0)"; "color(--own 1 2 3)"; "device-cmyk(0 0 0 0)"; "canvas"; "foo(1)";
    ];
  List.iter unread
    [
      "opacity:0;opacity:calc(1)"; "stroke:red;stroke-width:0;stroke-width:1lh"; "display:none;display:contents";
      "display:none;display:inline flow"; "display:none;display:-webkit-box";
      "transform:scale(0);transform:skewX(90deg)"; "transform:scale(0);transform:scale(50%)";
    ];
  unread "fill:bogus"; unread "fill:none;stroke:bogus"; unread "fill:bogus;stroke:none"; bad "fill:#12345";
  List.iter unread
    [
      "fill:none;fill:ButtonText"; "fill:none;fill:context-fill";
      "fill:none;fill:-mine"; "opacity:1;opacity:inherit";
      "overflow:visible;overflow:overlay"; "mask:none;mask:url(#m)";
    ];
  bad "fill:rgb(1,2)"; bad "stroke-miterlimit:4;stroke-miterlimit:.5";
  check ("SC0341", "<style>rect{fill:none}</style>" ^ left "style='fill:bogus'");
  check ("SC0341", left "fill='bogus'")

let colours () =
  let colour expected value =
    let rect = Printf.sprintf "<rect fill='%s' width='1' height='1'/>" value in
    let r = ok ~resolution:1 value (svg ~box:"0 0 1 1" rect) in
    let found = if inside r 0 0 then Scc_pixels.Raster.colour_text r.colours.(0) else "none" in
    Alcotest.(check string) value expected found
  in
  colour "#000000" "color(display-p3 0 0 0)"; colour "#ffffff" "color(display-p3 1 1 1 / 1)"; colour "none"
    "color(display-p3 1 1 1 / .4)";
  colour "#ff8000" "color(srgb 1 50.2% none)"; colour "#bc0000" "color(srgb-linear .5 0 0)"; colour "#cd853f"
    "#CD853F icc-color(acmecmyk, 0.11, 0.48, 0.83, 0.00)";
  colour "#ff0000" "oklch(0.62796 0.25768 29.234)"; colour "#ff0000" "oklab(62.796% 0.22486 0.12585)";
  colour "none" "oklch(60% 0.1 30deg / 40%)";
  colour "#ff0000" "hwb(0 0% 0%)"; colour "#99cc99" "hwb(120deg 60% 20%)"; colour "#808080" "hwb(7 60% 60%)";
  colour "#00cc80" "hwb(157.6 0 20 / 1)"; colour "none" "hwb(none 0 none / .2)";
  colour "#ffffff" "lab(100 0 0)"; colour "#777777" "lab(50% none 0)"; colour "#ff0000" "lab(54.29 80.82 69.89)";
  colour "#008000" "lab(46.278 -47.552 48.583)"; colour "#008000" "lch(46.278 67.98 134.386)";
  colour "#0000ff" "lch(29.57% 87.54% 301.37)"; colour "#000000" "lch(0 0 0)";
  colour "#ff0000" "red  icc-color(x)";
  let refused expected value = check (expected, left (Printf.sprintf "fill='%s'" value)) in
  refused "SC0341" "color(rec2020 1 1 1)"; refused "SC0340" "color(srgb 1 1)"; refused "SC0340" "oklch(1, 1, 1)";
  refused "SC0340" "lab(1, 2, 3)"; refused "SC0341" "icc-color(x, 1)"

(* What is left out, with a warning at its place. *)
let warnings () =
  let told expected body =
    match Scc_pixels.Icon.read_warned ~resolution:16 ~path:"icon.svg" (svg body) with
    | Error d -> Alcotest.(check string) body expected (d.Diag.code :> string)
    | Ok (_, warnings) ->
      let one (d : Diag.t) = (d.code :> string) ^ " " ^ List.hd (String.split_on_char ' ' d.message) in
      Alcotest.(check string) body expected (String.concat ", " (List.map one warnings))
  in
  told "" (left ""); told "SC0324 programs" ("<script>a()</script>" ^ left ""); told "SC0324 programs"
    ("<script href='a.js'/><script/>" ^ left "");
  told "SC0324 programs" (left "onclick='a()'");
  told "SC0324 programs" ("<g onload='a()'><script/></g>" ^ left "");
  let blend mode = left (Printf.sprintf "style='mix-blend-mode:%s'" mode) in
  told "" (blend "normal"); told "" (blend "initial"); told "SC0324 colours" (blend "multiply");
  told "SC0324 colours" ("<style>rect{mix-blend-mode:screen}</style>" ^ left "");
  told "SC0341" (blend "plus-lighter"); told "SC0340" (blend "bogus"); told "SC0341" (blend "inherit");
  told "SC0324 programs, SC0324 colours" ("<script/>" ^ left "mix-blend-mode='hue'");
  check ("left", blend "multiply"); check ("none", left "style='mix-blend-mode:hue' opacity='0'")

(* A hint that helps: what it says of a drawing that is too fine, or too long. *)
let limits () =
  let refused ~resolution body =
    match Scc_pixels.Icon.read ~resolution ~path:"icon.svg" (svg ~box:"0 0 20 20" body) with
    | Ok _ -> Alcotest.failf "%s is read" body
    | Error d -> d.Diag.message ^ " | " ^ Option.value d.hint ~default:""
  in
  let says expected found =
    let n = String.length expected in
    let at i = String.equal (String.sub found i n) expected in
    if not (List.exists at (List.init (max 0 (String.length found - n + 1)) Fun.id)) then Alcotest.failf "%S" found
  in
  let fine = refused ~resolution:16 "<path stroke='red' stroke-dasharray='1e-9' d='M0 0h30'/>" in
  List.iter (fun what -> says what fine) [ "a limit"; "1000000 corners"; "`--resolution`"; "in parts" ];
  says "`--resolution 512`" (refused ~resolution:700 (left ""))

let () =
  let case name f = Alcotest.test_case name `Quick f in
  Alcotest.run "svg as it is written"
    [
      ( "kinds",
        [ case "switches" switches; case "texts" texts; case "numbers" numbers; case "blocks" blocks;
          case "colours" colours; case "warnings" warnings; case "limits" limits ] );
    ]
