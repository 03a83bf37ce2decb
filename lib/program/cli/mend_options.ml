open Scc_base
open Scc_exact
open Scc_geometry
open Scc_concave
open Cmdliner

type t = Mended.t

let grid =
  let doc =
    "Rounds every coordinate to the nearest multiple of $(docv), and prints how many vertices moved and how far. \
     With $(b,--weld), points that become equal become one vertex."
  in
  let positive = function
    | Some d when Rat.sign d <= 0 -> Error "the distance of --grid is to be greater than 0"
    | d -> Ok d
  in
  let value = Arg.(value & opt (some Options.rational) None & info [ "grid" ] ~docv:"DISTANCE" ~doc) in
  Term.(term_result' ~usage:true (const positive $ value))

let weld =
  Options.flag [ "weld" ]
    "Makes equal points one vertex, as many programs give every face corners of its own, and removes faces \
     without an area, and faces that are there twice. Two solids that share a face keep it twice. If each face is \
     there from both sides, the first of both stays."

let orient =
  Options.flag [ "orient" ]
    "Turns faces over so that all are counter-clockwise from outside, and names them. A piece that lies within a \
     solid is taken for a hollow of it, whose faces look into the hollow, and a piece in a hollow for a solid. \
     Both may touch. Any other closed piece that is inside out is turned over, unless others together surround \
     all of it. Whether they touch makes no difference, nor does $(b,--weld) if each piece is \
     closed before it."

let merge =
  Options.flag [ "merge" ]
    "Makes one face of neighbouring faces that are in one plane, exactly: most files have triangles only, and a \
     template has maximal faces. First, faces that are not closed take in corners of others that are within \
     their edges; $(b,--orient) comes after this."

let term =
  let make grid weld orient merge = { Mended.grid; weld; orient; merge } in
  Term.(const make $ grid $ weld $ orient $ merge)

type told = (string * string) list

let apply o set =
  Result.map_error
    (fun why -> [ Diag.error Code.overused_edge Span.none "the faces cannot be oriented: %s" why ])
    (Mended.apply o set)

(* In the order in which they help. *)
let helping (set : Polyhedron.ifs) faults =
  let some test = List.exists test faults in
  let twice = lazy (Scc_mesh.Mend.has_faces_twice set) in
  let doubled = function
    | Polyhedron_fault.Repeated_edge _ | Flat _ | Separate_solids _ -> Lazy.force twice
    | _ -> false
  in
  let no_area = function
    | Polyhedron_fault.Degenerate_face (f, _) | Self_crossing (f, _) -> Scc_mesh.Slivers.is_sliver set f
    | Short_face _ -> true
    | _ -> false
  in
  let welded = function
    | Polyhedron_fault.Same_position _ | Unused_vertex _ -> true
    | f -> doubled f || no_area f
  in
  let tries =
    [
      (some welded, "--weld");
      (some (function Polyhedron_fault.Turned_face _ | Inward -> true | _ -> false), "--orient");
      (some (function Polyhedron_fault.Coplanar_neighbours _ -> true | _ -> false), "--merge");
    ]
  in
  List.filter_map (fun (wanted, name) -> if wanted then Some name else None) tries

let closing set faults =
  match Mended.closing set faults with
  | Some d -> [ "--grid " ^ Decimal.significant ~digits:1 d; "--weld" ]
  | None -> (
      match Mended.merging set faults with
      | Some `Alone -> [ "--merge" ]
      | Some `Welded -> [ "--weld"; "--merge" ]
      | None -> [])

let all_helping set faults =
  let closing = closing set faults in
  closing @ List.filter (fun t -> not (List.mem t closing)) (helping set faults)

(* A piece is closed if its faces share vertices. *)
let of_inside_out set =
  let helps =
    match Oriented.make set with
    | Ok t -> Result.is_ok (United.surface ~tick:ignore t.set)
    | Error _ -> false
  in
  if helps then "to mend it, add --orient"
  else if Oriented.pieces set = 0 then "to mend it, add --weld --orient"
  else "turn that part over in the program that made the mesh"

let of_nothing set =
  if Mended.one_side_each set then "to mend it, add --weld: each face is there from both sides" else Flat_mesh.cure

let text told = String.concat "" (List.map (fun (_, line) -> line ^ "\n") told)
