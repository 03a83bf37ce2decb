open Scc_exact
open Scc_geometry
open Scc_json
open Scc_runs
open Json_format

type t = {
  name : string;
  exit : int;
  source : Diag_json.source;
  diagnostics : Scc_base.Diag.t list;
  mended : (string * string) list;
  snap : (Rat.t * Scc_snap.Snap.snapped) option;
  outer : Scc_snap.Outer.t option;
  report : Solid_report.t;
}

let in_shape name t = named ~file:"shape" name t

(* {1 Faults} *)

(* Codes of what may be wrong with a solid. *)
let fault_code =
  let is_one code = code = "SC0204" || (String.length code = 6 && String.sub code 0 4 = "SC03") in
  let wrong json =
    if Option.fold ~none:false ~some:is_one (Json.string json) then None else Some "is the code of no such fault"
  in
  constrained [ ("pattern", `String "^SC(0204|03[0-9]{2})$") ] wrong Shared.code

let names r = (Solid_report.vertex_name r, Solid_report.face_name r)

let fault =
  let of_names f (r, fault) =
    let vertex, face = names r in
    f ~vertex ~face fault
  in
  fields
    [
      field "kind" (form [ { set = "a-z-"; least = 1; most = None } ]) (fun (_, f) -> Polyhedron_fault.kind f);
      field "code" fault_code (fun (_, f) -> (Polyhedron_fault.code f :> string));
      field "message" some_text (of_names Polyhedron_fault.message);
      field "hint" (nullable text) (of_names Polyhedron_fault.hint);
    ]
  |> in_shape "fault"

let faults =
  let of_report (r : Solid_report.t) =
    match r.verdict with Accepted _ -> [] | Rejected faults -> List.map (fun f -> (r, f)) faults
  in
  checked (from of_report (list fault))

let warning = in_shape "warning" Diag_json.brief

let warnings (r : Solid_report.t) =
  match r.verdict with Accepted _ -> Solid_report.faults r | Rejected _ -> []

(* {1 Definition 4.3} *)

let condition =
  let witness ((r : Solid_report.t), (_, witness)) =
    let vertex, face = names r in
    Option.map (Definition_4_3.explain r.paper ~vertex ~face) witness
  in
  fields
    [
      field "number" (integer ~least:1 ~most:7 ()) (fun (_, (n, _)) -> n);
      field "statement" some_text (fun (_, (n, _)) -> Definition_4_3.statement n);
      field "holds" bool (fun (_, (_, witness)) -> Option.is_none witness);
      field "witness" (nullable text) witness ~about:"Why it fails.";
    ]

let paper =
  let conditions (r : Solid_report.t) = List.map (fun c -> (r, c)) r.paper.conditions in
  let whole f (r : Solid_report.t) = f r.paper in
  fields
    [
      field "holds" bool (whole Definition_4_3.holds);
      field "conditions" (list ~least:7 ~most:7 condition) conditions;
      field "euler" (integer ()) (whole Definition_4_3.euler) ~about:"V - E + F with unordered edges.";
      field "euler_ordered" (integer ()) (whole Definition_4_3.euler_ordered)
        ~about:"The same with ordered pairs, as printed.";
    ]
  |> in_shape "paper"

(* {1 Solids} *)

let mass =
  fields
    [
      field "volume" Shared.rational (fun (m : Mass_properties.t) -> m.volume);
      field "centroid" Shared.vector (fun (m : Mass_properties.t) -> m.centroid);
      field "inertia" Shared.matrix (fun (m : Mass_properties.t) -> m.inertia)
        ~about:"About the centroid, for density 1.";
      field "inertia_of_unit_mass" Shared.matrix (Mass_properties.inertia ~mass:Rat.one);
    ]
  |> in_shape "mass"

let mass_of (r : Solid_report.t) = match r.verdict with Accepted (_, m) -> Some m | Rejected _ -> None

let vertex = fields [ field "name" some_text fst; field "position" Shared.vector snd ] |> in_shape "vertex"

let corner =
  let is_one ((r : Solid_report.t), i) = i >= 0 && i < Array.length r.set.ifs_vertices in
  let name ((r, i) as c) = if is_one c then Some (Solid_report.vertex_name r i) else None in
  union [ case text name ignore; case (integer ()) (fun (_, i) -> Some i) ignore ]

let face =
  let corners (r, (_, corners)) = List.map (fun i -> (r, i)) (Array.to_list corners) in
  fields
    [
      field "name" some_text (fun (_, (name, _)) -> name);
      field "corners" (list corner) corners ~about:"Names of vertices; a number is an index that no vertex has.";
    ]
  |> in_shape "face"

let geometry =
  let faces (r : Solid_report.t) = List.map (fun f -> (r, f)) (Array.to_list r.set.ifs_faces) in
  all
    [
      field "vertices" (array vertex) (fun (r : Solid_report.t) -> r.set.ifs_vertices);
      field "faces" (list face) faces;
      field "edges" natural (fun (r : Solid_report.t) -> r.edges) ~about:"How many, unordered.";
    ]

(* {1 What was done to the shape first} *)

let snapped =
  let moved (_, (s : Scc_snap.Snap.snapped)) =
    let all = List.mapi (fun v by -> (fst s.set.ifs_vertices.(v), by)) (Array.to_list s.moved) in
    List.filter (fun (_, by) -> Rat.sign by > 0) all
  in
  let short (_, by) = Decimal.significant ~digits:3 by in
  let vertex = fields [ field "vertex" text fst; field "by" text short ] in
  fields
    [
      field "distance" Shared.rational fst ~about:"That no vertex moves farther than.";
      field "moved" (list vertex) moved ~about:"The vertices that moved, and how far: three digits, for people.";
      field "turned_over" bool (fun (_, (s : Scc_snap.Snap.snapped)) -> s.turned_over)
        ~about:"All faces were listed clockwise.";
      field "bits" natural (fun (_, (s : Scc_snap.Snap.snapped)) -> s.bits)
        ~about:"Of the longest coordinate, numerator and denominator.";
    ]

let simplified =
  fields
    [
      field "faces_of_hull" (integer ~least:4 ()) (fun (o : Scc_snap.Outer.t) -> o.faces)
        ~about:"How many faces the hull has.";
      field "beyond" Shared.rational (fun (o : Scc_snap.Outer.t) -> o.beyond)
        ~about:
          "No point of the shape is farther from the hull: the greatest distance, or where that is irrational, \
           more than it by less than two in 2^40.";
    ]

(* {1 The report} *)

let report =
  all
    [
      field "accepted" bool Solid_report.accepted ~about:"It is a convex closed polyhedron.";
      field "faults" faults Fun.id ~about:"Why it is not, the most telling first.";
      field "warnings" (list warning) warnings;
      field "definition_4_3" paper Fun.id ~about:"The seven conditions as printed, each by itself.";
      field "mass_properties" (nullable mass) mass_of
        ~about:"Of the uniform solid in body space; null when not accepted.";
    ]

let report_members = all [ report; geometry ]

let format =
  fields
    (Shared.head "scc-shape" 1
     @ [
       field "exit" (one_of [ 0; 3 ]) (fun t -> t.exit);
       field "name" text (fun t -> t.name);
       within (fun t -> t.report) report;
       within (fun t -> t.mended) Mended_json.field;
       maybe "snapped" snapped (fun t -> t.snap)
         ~about:"How far --snap moved vertices; there with that option alone.";
       maybe "simplified" simplified (fun t -> t.outer)
         ~about:"What --faces did to the hull; there with that option alone.";
       within (fun t -> t.report) geometry;
       field "diagnostics" Diag_json.formats (fun t -> (t.source, t.diagnostics))
         ~about:"Warnings of what is read otherwise, or not, in the files.";
     ])

let document ~name ~exit ~source ~diagnostics ?(mended = []) ?snap ?outer report =
  write format { name; exit; source; diagnostics; mended; snap; outer; report }
