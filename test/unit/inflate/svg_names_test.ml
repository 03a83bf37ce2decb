(* Every element and attribute of SVG is read, paints nothing, or is refused: what is not read changes no pixel. *)
open Scc_base
open Scc_pixels

let lines =
  let file = open_in_bin "svg_names.txt" in
  let text = really_input_string file (in_channel_length file) in
  close_in file;
  List.filter (fun l -> l <> "" && l.[0] <> '#') (String.split_on_char '\n' text)

let picture body =
  let text = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 40 30'>" ^ body ^ "</svg>" in
  match Icon.read ~resolution:80 ~path:"icon" text with
  | Ok r -> Ok (Array.to_list r.colours, Bytes.to_string r.alphas)
  | Error d -> Error (d.Diag.code :> string)

let same = Result.equal ~ok:(fun (a, b) (c, d) -> List.equal Int.equal a c && String.equal b d) ~error:String.equal
let square = "<rect width='9' height='9'/>"
let inside = "<rect x='20' width='9' height='9'/>"

(* Each shape as it covers the same square, which is filled by its attributes. *)
let outlines =
  [
    ("path", "d='M20 0h9v9h-9z'"); ("rect", "x='20' width='9' height='9'"); ("circle", "cx='25' cy='5' r='5'");
    ("ellipse", "cx='25' cy='5' rx='5' ry='4'"); ("polygon", "points='20,0 29,0 29,9 20,9'");
    ("polyline", "points='20,0 29,0 29,9 20,9'"); ("line", "x1='20' x2='29' y1='5' y2='5' stroke-width='6'");
  ]

let drawn element more =
  match List.assoc_opt element outlines with
  | Some outline ->
    (* An attribute that is given is not given twice. *)
    let name = List.hd (String.split_on_char '=' more) in
    let parts = List.filter (fun p -> p <> "") (String.split_on_char '\'' outline) in
    let rec pairs = function a :: v :: rest -> (String.trim a, v) :: pairs rest | _ -> [] in
    let kept = List.filter (fun (a, _) -> a <> name ^ "=") (pairs parts) in
    Printf.sprintf "<%s %s %s/>" element (String.concat " " (List.map (fun (a, v) -> a ^ "'" ^ v ^ "'") kept)) more
  | None when element = "use" ->
    let target = if String.length more > 4 && String.sub more 0 4 = "href" then "" else "href='#r'" in
    Printf.sprintf "<defs><rect id='r' x='20' width='9' height='9'/></defs><use %s %s/>" target more
  | None -> Printf.sprintf "<%s %s>%s</%s>" element more inside element

(* A value that a reader cannot but notice; of others, nonsense. *)
let noticed =
  [
    ("display", "none"); ("visibility", "hidden"); ("opacity", "0"); ("fill-opacity", "0"); ("fill", "none");
    ("stroke", "red"); ("transform", "scale(9)"); ("style", "display:none"); ("fill-rule", "nonsense");
  ]

(* These matter beside others alone; so do the width and height of a use, for what has a viewport. *)
let beside =
  [
    "stroke-width"; "stroke-opacity"; "stroke-dasharray"; "stroke-dashoffset"; "stroke-linecap"; "stroke-linejoin";
    "stroke-miterlimit"; "color"; "transform-origin"; "transform-box"; "overflow"; "paint-order";
    "preserveAspectRatio"; "vector-effect"; "stop-color"; "stop-opacity";
  ]

(* By the specifications these may change what is painted, of themselves or with others: none may be still. *)
let seen =
  String.split_on_char ' '
    "display visibility opacity fill fill-opacity fill-rule stroke stroke-width stroke-opacity color \
     transform style clip-path mask filter clip marker-start marker-mid marker-end vector-effect \
     systemLanguage requiredExtensions requiredFonts requiredFormats d width height rx ry cx cy r points"

let check_attribute element name =
  let value = Option.value (List.assoc_opt name noticed) ~default:"nonsense" in
  let found = picture (square ^ drawn element (Printf.sprintf "%s='%s'" name value)) in
  let plain = picture (square ^ drawn element "") in
  let what = element ^ " " ^ name in
  let still = match Svg_table.attribute element name with Still -> true | Read | Unread _ -> false in
  Alcotest.(check bool) (what ^ " is seen, and not still") false (still && List.mem name seen);
  match Svg_table.attribute element name with
  | Still -> Alcotest.(check bool) (what ^ " changes nothing") true (same plain found)
  | Unread _ -> Alcotest.(check bool) (what ^ " is refused") true (same (Error "SC0341") found)
  | Read when element = "use" && List.mem name [ "width"; "height" ] -> ()
  | Read when List.mem name beside || (element = "line" && name <> "stroke" && Result.is_ok found) -> ()
  | Read -> Alcotest.(check bool) (what ^ " is read") false (same plain found)

(* Values that are read are looked at also where nothing is painted by them. *)
let check_nonsense element name =
  let refuse what body =
    match picture (square ^ body) with
    | Error ("SC0340" | "SC0341") -> ()
    | Error code -> Alcotest.failf "%s: %s" what code
    | Ok _ -> Alcotest.failf "%s is read" what
  in
  let what = Printf.sprintf "%s %s='nonsense'" element name in
  if Svg_table.attribute element name = Read && name <> "style" then begin
    refuse what (drawn element (name ^ "='nonsense'"));
    if Svg_table.property name = Read then
      refuse (what ^ " in a style") (drawn element (Printf.sprintf "style='%s:nonsense'" name))
  end

(* Of elements that are painted by others, which need not be there. *)
let elsewhere =
  let viewport = "x y width height viewBox preserveAspectRatio" in
  let gradient = " gradientUnits gradientTransform spreadMethod" in
  [
    ("linearGradient", "x1 y1 x2 y2" ^ gradient); ("radialGradient", "cx cy r fx fy fr" ^ gradient);
    ("stop", "offset"); ("clipPath", "clipPathUnits"); ("symbol", viewport); ("svg", viewport);
  ]

let check_elsewhere (element, names) () =
  let one name value =
    match picture (Printf.sprintf "%s<%s %s='%s'/>" square element name value) with
    | Error "SC0340" -> ()
    | Error _ | Ok _ -> Alcotest.failf "%s %s='%s' is read" element name value
  in
  let wrong name =
    let lists = List.mem name [ "gradientTransform"; "preserveAspectRatio" ] in
    [ "nonsense"; "1 nonsense" ] @ if lists then [] else [ "" ]
  in
  List.iter (fun name -> List.iter (one name) (wrong name)) (String.split_on_char ' ' names);
  let root name =
    let text = Printf.sprintf "<svg xmlns='http://www.w3.org/2000/svg' %s %s='nonsense'>%s</svg>" in
    let box = if name = "viewBox" then "width='9' height='9'" else "viewBox='0 0 40 30'" in
    match Icon.read ~resolution:80 ~path:"icon" (text box name square) with
    | Error _ -> ()
    | Ok _ -> Alcotest.failf "%s='nonsense' of the whole drawing is read" name
  in
  if element = "svg" then List.iter root (String.split_on_char ' ' names)

let check line () =
  match String.split_on_char ' ' line with
  | element :: mark :: attributes ->
    let alone = picture square in
    let found = picture (square ^ "<" ^ element ^ (if element = "text" then ">a</text>" else "/>")) in
    (match (mark, Svg_table.element element) with
     | "group", Group | "shape", Shape | "viewport", Viewport | "silent", Silent ->
       Alcotest.(check bool) (element ^ " paints nothing") true (same alone found)
     | "use", Use -> Alcotest.(check bool) "a use of nothing" true (same alone found || Result.is_error found)
     | "refused", Refused _ -> Alcotest.(check bool) (element ^ " is refused") true (same (Error "SC0341") found)
     | _ -> Alcotest.failf "%s is not in the list `%s`" element mark);
    List.iter (check_attribute element) attributes;
    List.iter (check_nonsense element) attributes
  | _ -> Alcotest.fail line

let () =
  let case line = Alcotest.test_case (List.hd (String.split_on_char ' ' line)) `Quick (check line) in
  let unpainted (element, names) = Alcotest.test_case element `Quick (check_elsewhere (element, names)) in
  Alcotest.run "svg names" [ ("elements", List.map case lines); ("elsewhere", List.map unpainted elsewhere) ]
