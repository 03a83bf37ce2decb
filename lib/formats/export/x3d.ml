open Scc_exact
open Scc_geometry
open Scc_calculus

let number = Floats.text
let point v = String.concat " " (List.map number (Array.to_list (Floats.point v)))
let rotation q = String.concat " " (List.map number (Array.to_list (Floats.axis_angle q)))

(* {1 Shapes}

   A mesh is written where it is needed first, and used from then on. *)

let corner_indices (s : Solid.t) =
  let face (_, around) = String.concat " " (List.map string_of_int (Array.to_list around)) ^ " -1" in
  String.concat " " (List.map face (Array.to_list s.polyhedron.faces))

let channel c = number (Float.of_int (c * 1000 / 255) /. 1000.)

(* A part that the file has already, by its number in the figure. *)
type written = Family of int | Mesh of int

let appearance put (written : (written, unit) Hashtbl.t) (f : Figure.family) i =
  if Hashtbl.mem written (Family i) then put (Printf.sprintf "<Appearance USE='family_%d'/>" i)
  else (
    Hashtbl.add written (Family i) ();
    let r, g, b = f.rgb in
    put
      (Printf.sprintf
         "<Appearance DEF='family_%d'><Material diffuseColor='%s %s %s' transparency='%s'/>\
          <MetadataString name='template' value=%s/></Appearance>"
         i (channel r) (channel g) (channel b)
         (number (1. -. Figure.opacity f))
         (Xml.quoted (Printf.sprintf "\"%s\"" f.name))))

let shape put (written : (written, unit) Hashtbl.t) figure i =
  if Hashtbl.mem written (Mesh i) then put (Printf.sprintf "<Shape USE='shape_%d'/>\n" i)
  else (
    Hashtbl.add written (Mesh i) ();
    let (solid : Solid.t), family = (Figure.meshes figure).(i) in
    put (Printf.sprintf "<Shape DEF='shape_%d'>" i);
    appearance put written (Figure.families figure).(family) family;
    let corners = List.init (Array.length solid.vertices) (fun k -> point (Solid.vertex solid k)) in
    put
      (Printf.sprintf "<IndexedFaceSet coordIndex='%s'><Coordinate point='%s'/></IndexedFaceSet></Shape>\n"
         (corner_indices solid) (String.concat ", " corners)))

(* {1 Bodies} *)

let leaf_name (l : Model.leaf) i = Printf.sprintf "leaf_%d_%s" i (Xml.name l.name)

let leaf put written figure (l : Model.leaf) i ~centre (track : Track.t) =
  let first = track.keys.(0) in
  let there = match track.gone with Some t when Rat.sign t = 0 -> " scale='0 0 0'" | Some _ | None -> "" in
  put
    (Printf.sprintf "<Transform DEF='%s' translation='%s' rotation='%s'%s>\n" (leaf_name l i)
       (point (Vec.sub first.at centre))
       (rotation first.turned) there);
  let metadata = Xml.quoted (Printf.sprintf "\"%s\" \"%s\"" l.name l.template) in
  put (Printf.sprintf "<MetadataString name='name and template' value=%s/>\n" metadata);
  Array.iteri
    (fun part (p : Model.part) ->
       let mesh = Figure.mesh figure ~leaf:i ~part in
       if Vec.is_zero p.offset then shape put written figure mesh
       else (
         put (Printf.sprintf "<Transform translation='%s'>" (point p.offset));
         shape put written figure mesh;
         put "</Transform>\n"))
    l.parts;
  put "</Transform>\n"

(* {1 Motion} *)

let interpolator put ~kind ~from ~target ~field ~name keys values =
  put
    (Printf.sprintf "<%s DEF='%s' key='%s' keyValue='%s'/>\n" kind name (String.concat " " keys)
       (String.concat ", " values));
  let route from event target field =
    put (Printf.sprintf "<ROUTE fromNode='%s' fromField='%s' toNode='%s' toField='%s'/>\n" from event target field)
  in
  route from "fraction_changed" name "set_fraction";
  route name "value_changed" target field

let motion put (l : Model.leaf) i ~centre ~over (track : Track.t) =
  let target = leaf_name l i in
  let fraction time = number (Floats.of_rat (Rat.div time over)) in
  let keys = List.map (fun (k : Track.key) -> fraction k.time) (Array.to_list track.keys) in
  let values f = List.map f (Array.to_list track.keys) in
  let put_one kind field name keys values =
    let name = Printf.sprintf "%s_%d" name i in
    interpolator put ~kind ~from:"clock" ~target ~field ~name keys values
  in
  if Track.moves track then (
    put_one "PositionInterpolator" "set_translation" "way" keys
      (values (fun k -> point (Vec.sub k.at centre)));
    if Track.turns track then
      put_one "OrientationInterpolator" "set_rotation" "turn" keys (values (fun k -> rotation k.turned)));
  match track.gone with
  | Some t when Rat.sign t > 0 ->
    put_one "PositionInterpolator" "set_scale" "there" [ "0"; fraction t; fraction t; "1" ]
      [ "1 1 1"; "1 1 1"; "0 0 0"; "0 0 0" ]
  | Some _ | None -> ()

let meta put name content =
  put (Printf.sprintf "<meta name='%s' content=%s/>\n" name (Xml.quoted content))

let file (f : Film.t) put =
  let m = Film.model f in
  let figure = Figure.make m and tracks = Film.tracks f and written = Hashtbl.create 64 in
  let centre = Figure.centre m (Film.initial f) and over = Film.duration f in
  put "<?xml version='1.0' encoding='UTF-8'?>\n";
  put "<!DOCTYPE X3D PUBLIC 'ISO//Web3D//DTD X3D 3.3//EN' 'http://www.web3d.org/specifications/x3d-3.3.dtd'>\n";
  put "<X3D profile='Interchange' version='3.3'>\n<head>\n";
  meta put "title" f.title;
  meta put "generator" "scc";
  meta put "identifier" f.origin.digest;
  meta put "description"
    "Exact up to rounding at the keys of the interpolators; between them bodies that turn are near the run only.";
  put "</head>\n<Scene>\n<Background skyColor='1 1 1'/>\n";
  (* z up becomes y up *)
  put
    (Printf.sprintf "<Transform rotation='1 0 0 -1.5707963267948966'>\n<Transform translation='%s'>\n"
       (point centre));
  Array.iteri (fun i track -> leaf put written figure m.leaves.(i) i ~centre track) tracks;
  put "</Transform>\n</Transform>\n";
  if Rat.sign over > 0 then (
    put
      (Printf.sprintf "<TimeSensor DEF='clock' cycleInterval='%s' loop='true'/>\n"
         (number (Floats.of_rat over)));
    Array.iteri (fun i track -> motion put m.leaves.(i) i ~centre ~over track) tracks);
  put "</Scene>\n</X3D>\n"
