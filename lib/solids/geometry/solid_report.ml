open Scc_base
open Scc_exact

type verdict =
  | Accepted of Polyhedron.t * Mass_properties.t
  | Rejected of Polyhedron_fault.t list

type t = { set : Polyhedron.ifs; edges : int; verdict : verdict; paper : Definition_4_3.t }

let make set =
  let paper = Definition_4_3.check set in
  let verdict =
    match Polyhedron.of_ifs set with
    | Ok p -> Accepted (p, Mass_properties.of_polyhedron p)
    | Error faults -> Rejected faults
  in
  { set; edges = paper.edges; verdict; paper }

let accepted r =
  match r.verdict with
  | Accepted _ -> true
  | Rejected _ -> false

let off_centre r =
  match r.verdict with
  | Accepted (_, mass) when not (Vec.is_zero mass.centroid) -> Some mass.centroid
  | Accepted _ | Rejected _ -> None

let vertex_name r i = fst r.set.ifs_vertices.(i)
let face_name r i = fst r.set.ifs_faces.(i)

let fault_diagnostic r fault =
  let vertex = vertex_name r and face = face_name r in
  Diag.error (Polyhedron_fault.code fault) Span.none
    ?hint:(Polyhedron_fault.hint ~vertex ~face fault)
    "%s"
    (Polyhedron_fault.message ~vertex ~face fault)

let faults r =
  match (r.verdict, off_centre r) with
  | Rejected faults, _ -> List.map (fault_diagnostic r) faults
  | Accepted _, None -> []
  | Accepted _, Some centroid ->
    [
      Diag.warning Code.off_centre Span.none
        "the centroid %s is not the origin of body space (positions and motion are of the centroid)"
        (Vec.in_short centroid);
    ]

(* {1 Text} *)

let max_faults = 20
let line b fmt = Printf.ksprintf (fun s -> Buffer.add_string b (s ^ "\n")) fmt

let add_verdict b r =
  let say d =
    let severity = if Diag.is_error d then "error" else "warning" in
    line b "  %s[%s]: %s" severity d.Diag.code d.message;
    Option.iter (line b "    hint: %s") d.hint
  in
  line b "convex closed polyhedron: %s" (if accepted r then "yes" else "no");
  let all = faults r in
  List.iteri (fun i d -> if i < max_faults then say d) all;
  let more = List.length all - max_faults in
  if more > 0 then line b "  and %d more" more

let add_paper b r =
  let paper = r.paper in
  line b "Definition 4.3, as printed: %s"
    (if Definition_4_3.holds paper then "all seven conditions hold" else "not all conditions hold");
  let condition (n, witness) =
    match witness with
    | None -> line b "  %d. holds: %s" n (Definition_4_3.statement n)
    | Some w ->
      line b "  %d. fails: %s" n (Definition_4_3.statement n);
      let why = Definition_4_3.explain paper ~vertex:(vertex_name r) ~face:(face_name r) w in
      line b "     %s" why
  in
  List.iter condition paper.conditions;
  line b "  (7 with ordered pairs of vertices for edges: %d - %d + %d = %d)" paper.vertices
    paper.directed_edges paper.faces
    (Definition_4_3.euler_ordered paper)

(* What a line has of an exact number. Corners where many planes meet may have numbers of 10^5 digits. *)
let most = 400
let exact v = Vec.in_short ~most v

let add_tensor b what (m : Mat.t) =
  line b "inertia about the centroid, %s:" what;
  List.iter (fun row -> line b "  %s" (exact row)) [ m.r0; m.r1; m.r2 ]

let add_mass b r =
  match r.verdict with
  | Rejected _ -> ()
  | Accepted (_, mass) ->
    line b "volume: %s" (Decimal.in_short ~most mass.volume);
    line b "centroid: %s" (exact mass.centroid);
    add_tensor b "density 1" mass.inertia;
    add_tensor b "mass 1" (Mass_properties.inertia ~mass:Rat.one mass)

let max_names = 40

let names all =
  let n = Array.length all in
  let first = List.init (Int.min n max_names) (fun i -> fst all.(i)) in
  if n = 0 then "none"
  else if n > max_names then Printf.sprintf "%s and %d more" (String.concat ", " first) (n - max_names)
  else String.concat ", " first

let to_text ~name r =
  let b = Buffer.create 1024 in
  line b "%s" name;
  line b "vertices: %d, edges: %d, faces: %d" r.paper.vertices r.edges r.paper.faces;
  line b "names of faces: %s" (names r.set.ifs_faces);
  line b "names of vertices: %s" (names r.set.ifs_vertices);
  add_verdict b r;
  add_paper b r;
  add_mass b r;
  Buffer.contents b
