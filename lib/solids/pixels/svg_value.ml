open Scc_exact
open Svg_number

type value = Length | Size | Auto_size | Share | Numbers | Path | Box | Ratio | Transform | One_of of string list

let units = One_of [ "userSpaceOnUse"; "objectBoundingBox" ]

(* By element: "x y", say, with the value of both. *)
let table =
  let viewport =
    [ ("x y", Length); ("width height", Auto_size); ("viewBox", Box); ("preserveAspectRatio", Ratio) ]
  in
  let gradient =
    [
      ("gradientUnits", units); ("gradientTransform", Transform);
      ("spreadMethod", One_of [ "pad"; "reflect"; "repeat" ]);
    ]
  in
  [
    ("path", [ ("d", Path) ]); ("polygon", [ ("points", Numbers) ]); ("polyline", [ ("points", Numbers) ]);
    ("rect", [ ("x y", Length); ("width height rx ry", Auto_size) ]);
    ("circle", [ ("cx cy", Length); ("r", Size) ]);
    ("ellipse", [ ("cx cy", Length); ("rx ry", Auto_size) ]); ("line", [ ("x1 y1 x2 y2", Length) ]);
    ("svg", viewport); ("symbol", viewport); ("use", [ ("x y", Length); ("width height", Auto_size) ]);
    ("clipPath", [ ("clipPathUnits", units) ]); ("stop", [ ("offset", Share) ]);
    ("linearGradient", ("x1 y1 x2 y2", Length) :: gradient);
    ("radialGradient", ("cx cy fx fy", Length) :: ("r fr", Size) :: gradient);
  ]

let kind element name =
  let has (names, _) = List.mem name (String.split_on_char ' ' names) in
  Option.map snd (List.find_opt has (Option.value (List.assoc_opt element table) ~default:[]))

let bad name text = raise (Bad (Printf.sprintf "the %s %S" name text))

(* [None] for units that depend on something else. *)
let length_of text = match length ~whole:Rat.one text with q -> Some q | exception Unread _ -> None
let is_length text = match length_of text with Some _ | None -> true | exception Bad _ -> false

let check_value name text = function
  | Length -> ignore (length_of text)
  | (Size | Auto_size) as kind ->
    if not (kind = Auto_size && String.equal text "auto") then
      Option.iter (fun q -> if Rat.sign q < 0 then raise (Bad (name ^ " is negative"))) (length_of text)
  | Share -> ignore (share text)
  | Numbers -> ignore (all text)
  | Path -> Svg_path.path text ignore
  | Box -> ignore (Aspect.box text)
  | Ratio -> Aspect.check text
  | Transform -> ignore (Svg_transform.of_text text)
  | One_of words -> if not (List.mem text words) then bad name text

let check (node : Svg_tree.node) =
  let one (name, text) = Option.iter (check_value name text) (kind node.name name) in
  List.iter one node.attributes
