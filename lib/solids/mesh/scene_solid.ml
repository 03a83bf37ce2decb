open Scc_base
open Scc_exact
open Scene
module F = Scene_fields

(* {1 Where something is} *)

(* One transform: by how much its rotation may be off, the greatest factor of its scales, and bounds of the lengths
   of its centre and translation. *)
type level = { off : Rat.t; factor : Rat.t; centre : Rat.t; shift : Rat.t }

(* [levels]: the innermost first. *)
type place = { map : Affine.t; levels : level list }

(* At least the length of a vector. *)
let size (v : Vec.t) = Rat.add (Rat.abs v.x) (Rat.add (Rat.abs v.y) (Rat.abs v.z))

(* How far what is off by [distance], of points no farther than [radius] from the origin, is off at the end. A
   transform stretches what is off before it by its factor at most. It turns a vector from its centre, which has
   been stretched, so that this is off by [off] times its length more. *)
let off_by levels ~radius distance =
  let step (radius, distance) l =
    let arm = Rat.mul l.factor (Rat.add radius l.centre) in
    let further = Rat.add (Rat.mul l.factor distance) (Rat.mul l.off arm) in
    (Rat.add arm (Rat.add l.centre l.shift), further)
  in
  snd (List.fold_left step (radius, distance) levels)

let turn ~path node name =
  match F.numbers ~path node name ~count:4 with
  | None -> (Mat.identity, Rat.zero)
  | Some n -> (
      match Turn.rotation (Vec.make n.(0) n.(1) n.(2)) n.(3) with
      | Some found -> found
      | None -> bad ~path node.kind "`%s` turns about an axis of length 0, or by an angle beyond 10^6" name)

let transform ~path node =
  let vector name default =
    match F.numbers ~path node name ~count:3 with
    | Some n -> Vec.make n.(0) n.(1) n.(2)
    | None -> Vec.make default default default
  in
  let shift = vector "translation" Rat.zero and centre = vector "center" Rat.zero in
  let scale = vector "scale" Rat.one in
  let rotation, off = turn ~path node "rotation" in
  let stretched, off' = turn ~path node "scaleOrientation" in
  let linear = Mat.mul rotation (Mat.mul stretched (Mat.mul (Mat.diagonal scale) (Mat.transpose stretched))) in
  if Rat.sign (Mat.det linear) = 0 then bad ~path node.kind "a scale of 0 makes everything flat";
  let translation = Vec.add shift (Vec.sub centre (Mat.apply linear centre)) in
  let factor = Rat.max (Rat.abs scale.x) (Rat.max (Rat.abs scale.y) (Rat.abs scale.z)) in
  (* The orientation of the scales is turned there and back. Without different scales that changes nothing. *)
  let even = Rat.equal scale.x scale.y && Rat.equal scale.y scale.z in
  let off = if even then off else Rat.add off (Rat.mul (Rat.of_int 2) off') in
  ({ Affine.linear; translation }, { off; factor; centre = size centre; shift = size shift })

(* {1 What is shown} *)

(* A word, and the file that it is in. *)
type seen = { file : string; word : Text.word }

type t = {
  mutable path : string;  (* of the file of what is shown *)
  library : Scene_library.t;
  scene : Scene_library.t -> path:string -> string -> file;
  loaded : (string, file) Hashtbl.t;  (* by its path *)
  mutable all : (string * file) list;  (* the last one first *)
  mutable around : string list;  (* the files whose Inlines are being shown *)
  mutable length : Rat.t;  (* the unit of the file of what is shown *)
  room : int ref;
  mutable count : int;
  mutable points : Vec.t list;
  mutable faces : (string option * int array) list;
  mutable near : (Rat.t * seen) option;  (* the greatest distance, and whose it is *)
  mutable left_out : seen option;  (* the first geometry without thickness *)
  mutable alone : seen option;  (* the first points without faces *)
  mutable hidden : seen option;  (* a node that shows nothing of what is in it *)
}

let seen t word = { file = t.path; word }

let geometry t place ~name node =
  let shape = Scene_shapes.make ~path:t.path ~room:!(t.room) node in
  spend ~path:t.path t.room node.kind shape.cost;
  let first = t.count and mirrored = Affine.mirrors place.map in
  let corners f =
    let n = Array.length f in
    Array.init n (fun i -> first + f.(if mirrored then n - 1 - i else i))
  in
  let name = if Option.is_some node.name then node.name else name in
  let off =
    if Rat.sign shape.distance = 0 && List.for_all (fun l -> Rat.sign l.off = 0) place.levels then Rat.zero
    else
      let radius = Array.fold_left (fun r v -> Rat.max r (size v)) Rat.zero shape.points in
      off_by place.levels ~radius shape.distance
  in
  let greatest = match t.near with Some (d, _) -> d | None -> Rat.zero in
  if Rat.compare off greatest > 0 then t.near <- Some (off, seen t node.kind);
  if shape.faces = [] && Array.length shape.points > 0 && Option.is_none t.alone then
    t.alone <- Some (seen t node.kind);
  t.count <- first + Array.length shape.points;
  t.points <- Array.fold_left (fun all v -> Affine.apply place.map v :: all) t.points shape.points;
  t.faces <- List.fold_left (fun all f -> (name, corners f) :: all) t.faces shape.faces

let truth_of_all t node name =
  match F.words ~path:t.path node name with
  | Some [ _ ] when not (String.equal node.kind.text "CADLayer") -> F.truth ~path:t.path node name
  | None -> true
  | Some words ->
    let hides (w : Text.word) = not (List.mem w.text [ "TRUE"; "true" ]) in
    Option.iter
      (fun w ->
         unread ~path:t.path w ~hint:"remove what is not to be seen"
           "a layer that hides some of its parts is not read")
      (List.find_opt hides words);
    true

(* What is inside of a group, in the fields of these names. *)
let inside t names node = List.concat_map (F.nodes ~path:t.path node) names

let chosen t node =
  let choices = inside t [ "choice"; "children" ] node in
  let given ((w : Text.word), value) =
    match value with Nodes l when List.mem w.text [ "choice"; "children" ] -> l | Nodes _ | Words _ -> []
  in
  let all = List.concat_map given node.fields in
  let which = F.integer ~path:t.path node "whichChoice" ~default:(-1) in
  match List.nth_opt all which with
  | Some choice when List.memq choice choices -> [ choice ]
  | Some _ | None -> []
  | exception Invalid_argument _ -> []

(* Shapes with a place of their own show what is in their `geometry`, and nothing else does. *)
let check_in_shape t ~in_shape (node : node) =
  if not in_shape then
    bad ~path:t.path node.kind "a %s stands in the `geometry` of a Shape, and not here" node.kind.text

(* {1 Other files} *)

let most_within = 32

let load t (at : Text.word) ~path text =
  match Hashtbl.find_opt t.loaded path with
  | Some file -> file
  | None ->
    let text = Source.blank_mark text in
    t.room := !(t.room) + (4 * String.length text);
    spend ~path:t.path t.room at 100;
    let file = t.scene t.library ~path text in
    F.check_all_unseen ~path file.nodes;
    Hashtbl.replace t.loaded path file;
    t.all <- (path, file) :: t.all;
    file

(* The first of the files that can be read, with its path; none if none is named. *)
let inline t (node : node) =
  let words = Option.value (F.words ~path:t.path node "url") ~default:[] in
  let urls = Scene_library.strings words in
  (* An address in the body of a prototype is beside the file of that. *)
  let beside = match words with w :: _ -> Scene_library.path_of t.library ~path:t.path w | [] -> t.path in
  let text path = if Hashtbl.mem t.loaded path then Ok "" else Scene_library.files t.library path in
  let one url = Beside.address text ~path:beside (Scene_library.file_of url) in
  let refuse ?(hint = "put what the other file has in the place of the Inline, or that file beside this one") url
      why =
    unread ~path:t.path (match words with first :: _ -> first | [] -> F.place node "url") ~hint
      "the file %s of this Inline is not read: %s" (Text.quote url) why
  in
  let rec first why = function
    | [] -> Option.map (fun (url, why) -> refuse url why) why
    | url :: rest -> (
        match one url with
        | Error text -> first (if Option.is_some why then why else Some (url, text)) rest
        | Ok (path, _) when List.mem path (t.path :: t.around) -> 
          refuse url "it is inside of itself" ~hint:"remove one of the Inlines that lead from the file to itself"
        | Ok _ when List.length t.around >= most_within ->
          refuse url ~hint:"put what is in some of these files into one"
            (Printf.sprintf "files are inside of each other more than %d deep" most_within)
        | Ok (path, text) -> Some (path, load t node.kind ~path text))
  in
  first None urls

(* A place within another one. *)
let inner t place (node : node) own level =
  let map = Affine.compose place.map own in
  if Affine.too_long map then
    bad ~path:t.path node.kind "the numbers of transforms inside of each other get too long";
  { map; levels = level :: place.levels }

let scaled t place node factor =
  if Rat.equal factor Rat.one then place
  else
    let own = { Affine.identity with linear = Mat.diagonal (Vec.make factor factor factor) } in
    inner t place node own { off = Rat.zero; factor; centre = Rat.zero; shift = Rat.zero }

let rec show t ?(in_shape = false) depth place ~name node =
  spend ~path:t.path t.room node.kind 1;
  if depth > max_depth then
    bad ~path:t.path node.kind "nodes are inside of each other more than %d deep" max_depth;
  match Scene_table.find node.kind.text with
  | Still -> ()
  | Left_out ->
    check_in_shape t ~in_shape node;
    if Option.is_none t.left_out then t.left_out <- Some (seen t node.kind)
  | Unread hint -> unread ~path:t.path node.kind ~hint "the node %s is not read" (Text.quote node.kind.text)
  | Read { role; read; still } ->
    F.check ~path:t.path node ~read ~still;
    let within ?in_shape = show t ?in_shape (depth + 1) in
    if not (truth_of_all t node "visible") then t.hidden <- Some (seen t node.kind)
    else (
      match role with
      | Group -> List.iter (within place ~name:None) (inside t [ "shape"; "children" ] node)
      | Transform ->
        let own, level = transform ~path:t.path node in
        let place = inner t place node own level in
        List.iter (within place ~name:None) (inside t [ "children" ] node)
      | Switch ->
        let shown = chosen t node in
        if shown = [] then t.hidden <- Some (seen t node.kind);
        List.iter (within place ~name:None) shown
      | Levels -> (
          match inside t [ "level"; "children" ] node with
          | first :: _ -> within place ~name:None first
          | [] -> ())
      | Inline -> (
          match if F.truth ~path:t.path node "load" then inline t node else None with
          | None -> t.hidden <- Some (seen t node.kind)
          | Some (path, file) ->
            let outer = t.path and around = t.around and length = t.length in
            t.path <- path;
            t.around <- outer :: around;
            t.length <- file.length;
            let place = scaled t place node (Rat.div file.length length) in
            List.iter (within place ~name:None) file.nodes;
            t.path <- outer;
            t.around <- around;
            t.length <- length)
      | Shape -> shape (within ~in_shape:true) t place node
      | Geometry -> check_in_shape t ~in_shape node; geometry t place ~name node
      | Points -> bad ~path:t.path node.kind "points stand in the `coord` of a shape, and not here")

and shape within t place node =
  match inside t [ "geometry" ] node with
  | [] -> ()
  | [ geometry ] -> (
      match Scene_table.find geometry.kind.text with
      | Read { role = Geometry; _ } | Left_out | Unread _ | Still -> within place ~name:node.name geometry
      | Read _ -> bad ~path:t.path geometry.kind "a %s is no geometry of a Shape" geometry.kind.text)
  | _ :: other :: _ -> bad ~path:t.path other.kind "a Shape has one geometry, and this is another"

(* {1 Warnings} *)

let at ~path (w : Text.word) = Span.make ~file:path ~start:w.start ~stop:(w.start + String.length w.text)
let at_seen { file; word } = at ~path:file word

let turned =
  "rotations become exact ones near by, and curved shapes inscribed polyhedra within 1/100 of the radius"

let bent = "a square of the grid that is not flat becomes two triangles, and the format leaves open which"

let swept =
  "frames and rotations become exact ones near by; a side that is not planar becomes two triangles, and the \
   format leaves open which"

let nearly t =
  let one (distance, seen) =
    Diag.warning Code.mesh_nearly (at_seen seen)
      ~hint:(match seen.word.text with "ElevationGrid" -> bent | "Extrusion" -> swept | _ -> turned)
      "what is read is up to %s from what the file describes, here the most"
      (Decimal.significant_above ~digits:3 distance)
  in
  Option.to_list (Option.map one t.near)

(* The field that an event sets. *)
let set name =
  match name with
  | "addChildren" | "removeChildren" -> "children"
  | _ when String.length name > 4 && String.equal (String.sub name 0 4) "set_" ->
    String.sub name 4 (String.length name - 4)
  | _ -> name

let moving ~path (file : file) =
  let moves change =
    match change.target with
    | Instance -> true
    | Nobody _ -> false
    | Field (node, field) -> (
        match Scene_table.find node.kind.text with
        | Read { read; _ } -> List.mem (set field) read
        | Still | Left_out | Unread _ -> false)
  in
  match List.find_opt moves file.changes with
  | None -> []
  | Some change ->
    [
      Diag.warning Code.mesh_left_out (at ~path change.at)
        ~hint:"nothing has to be done if the start is what is meant"
        "the scene changes while time passes, and is read as it is at its start";
    ]

let lost ~path (file : file) =
  let one change =
    match change.target with
    | Nobody name ->
      Some
        (Diag.warning Code.mesh_left_out (at ~path change.at)
           "no node has the name %s of this route, which is left out" (Text.quote name))
    | Instance | Field _ -> None
  in
  Option.to_list (List.find_map one file.changes)

let thin t =
  let one seen =
    Diag.warning Code.mesh_left_out (at_seen seen)
      ~hint:"nothing has to be done if the solid is what is meant"
      "lines and letters, such as this %s, bound no solid, and are left out" seen.word.text
  in
  Option.to_list (Option.map one t.left_out)

(* Points are a cloud if there is nothing else. *)
let points_alone t =
  let one seen =
    Diag.warning Code.mesh_left_out (at_seen seen) ~hint:"a hull takes them in, and --weld drops them"
      "points without faces, such as those of this %s, bound no solid" seen.word.text
  in
  if t.faces = [] then [] else Option.to_list (Option.map one t.alone)

let nothing t =
  match (t.hidden, t.left_out) with
  | None, Some { file; word } -> bad ~path:file word "the scene shows no faces: lines and letters bound no solid"
  | Some { file; word }, _ ->
    bad ~path:file word "the scene shows no faces: this %s shows nothing of what is in it" word.text
  | None, None -> ok (Text.error_at ~path:t.path 0 "the scene shows no faces")

let read ~files ~scene ~prototypes ~path text =
  let room = Scene.room ~size:(String.length text) in
  let library = Scene_library.make ~files ~room ~read:prototypes in
  let work () =
    let file = scene library ~path text in
    let t =
      {
        path; library; scene; loaded = Hashtbl.create 8; all = [ (path, file) ]; around = [];
        length = file.length; room; count = 0;
        points = []; faces = []; near = None; left_out = None; alone = None; hidden = None;
      }
    in
    List.iter (show t 0 { map = Affine.identity; levels = [] } ~name:None) file.nodes;
    F.check_all_unseen ~path file.nodes;
    if t.points = [] then nothing t;
    let all = List.rev t.all in
    let first f = match List.concat_map (fun (path, file) -> f ~path file) all with [] -> [] | d :: _ -> [ d ] in
    let warnings = nearly t @ thin t @ points_alone t @ first moving @ first lost in
    (Text.labelled t.points t.faces, List.map (Scene_library.located library) warnings)
  in
  match work () with
  | result -> Ok result
  | exception Refused d -> Error (Scene_library.located library d)
