open Scc_exact
open Svg_number

type view = { width : Rat.t; height : Rat.t }

let across view text = length ~whole:view.width text
let down view text = length ~whole:view.height text

let along view text =
  let squares = Rat.add (Rat.mul view.width view.width) (Rat.mul view.height view.height) in
  length ~whole:(Rat.root (Rat.mul Rat.half squares)) text

let nothing _ = ()

let points node =
  let rec pairs found = function
    | x :: y :: rest -> pairs ((x, y) :: found) rest
    | [ _ ] -> raise (Bad "points with an odd number of coordinates")
    | [] -> List.rev found
  in
  pairs [] (all (Option.value (Svg_tree.attribute node "points") ~default:""))

let outline view node =
  let attribute = Svg_tree.attribute node in
  let value read name = match attribute name with None -> Rat.zero | Some text -> read view text in
  let size read name =
    let q = value read name in
    if Rat.sign q < 0 then raise (Bad (name ^ " is negative"));
    q
  in
  (* [rx] and [ry], each like the other one if that is not given. *)
  let radii () =
    let given name = match attribute name with None | Some "auto" -> None | Some _ -> Some name in
    match (given "rx", given "ry") with
    | None, None -> (Rat.zero, Rat.zero)
    | Some _, None -> (size across "rx", size across "rx")
    | None, Some _ -> (size down "ry", size down "ry")
    | Some _, Some _ -> (size across "rx", size down "ry")
  in
  let centre () =
    let x = value across "cx" in
    (x, value down "cy")
  in
  let ellipse (rx, ry) = if Rat.sign rx = 0 || Rat.sign ry = 0 then nothing else Svg_path.ellipse (centre ()) rx
        ry in
  match node.name with
  | "path" -> Svg_path.path (Option.value (attribute "d") ~default:"")
  | "polygon" -> Svg_path.points ~closed:true (points node)
  | "polyline" -> Svg_path.points ~closed:false (points node)
  | "line" ->
    let from = (value across "x1", value down "y1") in
    Svg_path.points ~closed:false [ from; (value across "x2", value down "y2") ]
  | "circle" ->
    let r = size along "r" in
    ellipse (r, r)
  | "ellipse" -> ellipse (radii ())
  | "rect" ->
    let w = size across "width" and h = size down "height" in
    if Rat.sign w = 0 || Rat.sign h = 0 then nothing
    else Svg_path.rectangle (value across "x", value down "y") (w, h) (radii ())
  | _ -> nothing
