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
  | Mesh (path, m) -> Mesh_file.read c.report env ~read_file:c.read_file path { m with union = false }
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

let rec file (s : Ast.solid) =
  match s.it with
  | Mesh (path, m) -> Some (path, m)
  | Scaled (inner, _) -> file inner
  | Template _ | Faces _ | Hull _ -> None

let hint (set : Polyhedron.ifs) file (fault : Decomposed.fault) =
  match (fault, file) with
  | (Pieces (Apart _ | Island _) | Unsound (Cut _)), Some (_, (m : Ast.mending)) when not m.union ->
    Some "write `union` after the file: solids that overlap, share faces or touch become one"
  | Pieces (Outward _), Some (_, m) when not m.orient ->
    Some "write `orient` after the file: faces are turned over so that all look out of the solid"
  | (Inside_out _ | Nothing), Some (_, m) when Option.is_some (Mesh_file.union_hint set m fault) ->
    Mesh_file.union_hint set m fault
  | Nothing, Some _ -> Some Flat_mesh.cure
  | Too_many _, Some _ -> Some "`scc decompose` with --parts and -o writes a compound of more parts"
  | _ -> None

let report (c : Context.t) solid (set : Polyhedron.ifs) fault =
  let places = places solid in
  let whole = Templates.face_span places max_int in
  (* All faces of a file are at one place. *)
  let also f g =
    let place = Templates.face_span places g in
    if Span.equal place (Templates.face_span places f) then []
    else [ (place, Printf.sprintf "the face `%s` is here" (fst set.ifs_faces.(g))) ]
  in
  let file = file solid in
  let told ?notes at =
    let code, text = Decomposed.message set fault in
    Report.error c.report code at ?notes ?hint:(hint set file fault) "%s" text
  in
  match (fault : Decomposed.fault) with
  | Unsound (Structure faults) ->
    Templates.report_faults c ?mending:(Option.map snd file) ~decomposed:true places set faults
  | Unsound (Cut (f, g, _)) ->
    told (Templates.face_span places f) ~notes:(also f g)
  | Pieces (Apart (f, g) | Island (f, g)) ->
    told (Templates.face_span places f) ~notes:(also f g)
  | Pieces (Outward f) -> told (Templates.face_span places f)
  | Inside_out { face; _ } -> told (Templates.face_span places face)
  | Nothing | Too_many _ -> told whole

(* A compound is connected. *)
let one_group (c : Context.t) solid parts =
  let groups = Decomposed.groups parts in
  if groups > 1 then
    Report.error c.report Code.several_solids (Templates.face_span (places solid) max_int)
      ~hint:"each needs a compound of its own: `scc decompose --union` with -o writes them"
      "the union of the solids is in %d pieces that are not connected by areas" groups;
  groups = 1

let parts (c : Context.t) solid set =
  let united = match file solid with Some (_, m) -> m.union | None -> false in
  match if united then Decomposed.united ~names:true set else Decomposed.make set with
  | Ok parts -> if one_group c solid parts then Some parts else None
  | Error fault ->
    report c solid set fault;
    None

(* Everything that the attributes must say, and must not. *)
let checked (c : Context.t) at solid (a : Attributes.t) =
  Option.iter
    (fun at ->
       Report.error c.report Code.bad_absorber at "a compound absorbs nothing by itself"
         ~hint:"write `absorb` after the name of the compound, where a body of it is declared `fixed`")
    a.absorb;
  match a.mass with
  | None ->
    Report.error c.report Code.bad_value at "this compound has no mass"
      ~hint:
        (Printf.sprintf "write `mass m` with m > 0 after the %s: its parts share it by their volumes"
           (if Option.is_some (file solid) then "file" else "faces"));
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
  let mass = checked c at solid a in
  let*? set = set in
  if too_fine c solid.at set then None
  else
    let set = match file solid with Some (path, _) -> Mesh_file.flat c.report path set | None -> set in
    let*? drawn = parts c solid set in
    let*? mass = mass in
    Some (compound c at label drawn a mass)

let declare c env (h : Ast.head) solid attributes definitions =
  Templates.declare c env h definitions (make c h.declared.at solid attributes)
