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
      ("right", switch ("<foreignObject " ^ adobe ^ " x='0' width='1' height='1'/><g>" ^ right "" ^ "</g>"));
      ("left", switch (left "" ^ right "")); ("right", switch (left adobe ^ right "")); ("none", switch (left adobe));
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

let numbers () =
  List.iter check
    [
      ("left", "<rect width='10.' height='10.'/>"); ("left", "<rect width='10.px' height='+10.'/>");
      ("right", right "opacity='1.'"); ("left", "<path stroke='red' stroke-width='10.' d='M0 5H10.'/>");
      ("SC0340", "<rect width='.' height='10'/>"); ("SC0340", "<rect width='10..' height='10'/>");
      ("SC0340", left "style='opacity:1.'"); ("SC0340", "<style>rect{stroke-width:1.px}</style>" ^ left "");
    ]

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
        [ case "switches" switches; case "texts" texts; case "numbers" numbers; case "limits" limits ] );
    ]
