open Scc_base
open Scc_exact
open Scc_geometry
open Scc_syntax
open Scc_concave

let scaled (set : Polyhedron.ifs) (f : Vec.t) =
  let scale (name, (v : Vec.t)) = (name, Vec.make (Rat.mul f.x v.x) (Rat.mul f.y v.y) (Rat.mul f.z v.z)) in
  { set with ifs_vertices = Array.map scale set.ifs_vertices }

let rec read (c : Context.t) env (s : Ast.solid) =
  match s.it with
  | Faces (vertices, faces) -> Templates.listed_set c env vertices faces
  | Mesh (path, snap) -> Mesh_file.read c.report env ~read_file:c.read_file path snap
  | Scaled (inner, factors) ->
    let set = read c env inner and factors = Constant.scaling c.report env s.at factors in
    let*? set = set in
    Option.map (scaled set) factors
  | Template _ | Hull _ -> Bug.fail __POS__ "no solid that can be decomposed"

let too_fine (c : Context.t) at set =
  let fine = Polyhedron.too_fine set in
  if fine then
    Report.error c.report Code.number_too_large at "the common denominator of the coordinates is too large"
      ~hint:"use decimals, or fractions with few different denominators";
  fine

let rec places (s : Ast.solid) =
  match s.it with
  | Faces (vertices, faces) -> Templates.places_of s.at vertices faces
  | Scaled (inner, _) -> places inner
  | Mesh (path, _) -> Templates.places_of path.at [] []
  | Template _ | Hull _ -> Templates.places_of s.at [] []

let rec mending (s : Ast.solid) =
  match s.it with
  | Mesh (_, m) -> Some m
  | Scaled (inner, _) -> mending inner
  | Template _ | Faces _ | Hull _ -> None

let report (c : Context.t) solid (set : Polyhedron.ifs) fault =
  let places = places solid in
  let whole = Templates.face_span places max_int in
  (* All faces of a file are at one place. *)
  let also f g =
    let place = Templates.face_span places g in
    if Span.equal place (Templates.face_span places f) then []
    else [ (place, Printf.sprintf "the face `%s` is here" (fst set.ifs_faces.(g))) ]
  in
  let told ?notes at =
    let code, text = Decomposed.message set fault in
    Report.error c.report code at ?notes "%s" text
  in
  match (fault : Decomposed.fault) with
  | Unsound (Structure faults) -> List.iter (Templates.report_fault c ?mending:(mending solid) places set) faults
  | Unsound (Cut (f, g, _)) ->
    told (Templates.face_span places f) ~notes:(also f g)
  | Pieces (Apart (f, g) | Island (f, g)) ->
    told (Templates.face_span places f) ~notes:(also f g)
  | Pieces (Outward f) -> told (Templates.face_span places f)
  | Too_many _ -> told whole

let parts c solid set =
  match Decomposed.make set with
  | Ok parts -> Some parts
  | Error fault ->
    report c solid set fault;
    None

(* Everything that the attributes must say, and must not. *)
let checked (c : Context.t) at (a : Attributes.t) =
  Option.iter
    (fun at ->
       Report.error c.report Code.bad_absorber at "a compound absorbs nothing by itself"
         ~hint:"write `absorb` after the name of the compound, where a body of it is declared `fixed`")
    a.absorb;
  match a.mass with
  | None ->
    Report.error c.report Code.bad_value at "this compound has no mass"
      ~hint:"write `mass m` with m > 0 after the file: its parts share it by their volumes";
    None
  | Some (mass, _) -> if a.complete && Option.is_none a.absorb then Some mass else None

let compound (c : Context.t) at label (drawn : Parts.t) (a : Attributes.t) mass =
  let volume = Drawn.volume drawn.drawn.set in
  let linear = a.at.linear and translation = a.at.translation in
  let placement = { Affine.linear; translation = Form.at c.point translation } in
  let part (name, polyhedron) =
    let id = c.fresh () in
    let basic = { Shape.id; root = id; label = label ^ "." ^ name; polyhedron } in
    let own = (Mass_properties.of_polyhedron polyhedron).volume in
    let mass = Rat.mul mass (Rat.div own volume) in
    { Shape.name; basic; placement; place = translation; solid = c.solid basic linear; mass; span = at }
  in
  let parts = Array.map part drawn.parts in
  let sum = Array.fold_left (fun sum (p : Shape.part) -> Rat.add sum p.mass) Rat.zero parts in
  if not (Rat.equal sum mass) then Bug.fail __POS__ "parts that are not the whole";
  Shape.Compound
    {
      cid = c.fresh ();
      clabel = label;
      parts;
      open_glues = [];
      velocity = Attributes.velocity a;
      spin = Attributes.spin a;
      drawn = Some drawn;
    }

let make (c : Context.t) at (solid : Ast.solid) attributes env label =
  let set = read c env solid in
  let a = Attributes.read c.report env attributes in
  let mass = checked c at a in
  let*? set = set in
  if too_fine c solid.at set then None
  else
    let*? drawn = parts c solid set in
    let*? mass = mass in
    Some (compound c at label drawn a mass)

let declare c env (h : Ast.head) solid attributes definitions =
  Templates.declare c env h definitions (make c h.declared.at solid attributes)
