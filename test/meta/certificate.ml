let check = "lib/verification/certificate"
let search = "lib/verification/symbolic"

(* Foundation; polyhedra, rules about two solids as constraints; the kernel; rules and predicates on sets. *)
let shared =
  [
    "scc_base"; "scc_data"; "scc_exact"; "scc_geometry"; "scc_polyhedra"; "scc_offsets";
    "scc_calculus"; "scc_semantics"; "scc_property"; "scc_evaluate"; "scc_state_sets";
  ]

let sources folder =
  let is_source file = Filename.check_suffix file ".ml" || Filename.check_suffix file ".mli" in
  List.filter is_source (Tree.files folder)

let strangers () =
  List.filter (Tree.starts_with "scc_") (Wings.field "libraries" (Tree.read (check ^ "/dune")))
  |> List.filter (fun library -> not (List.mem library shared))

let borrowed () =
  let of_file file =
    let text = Tree.read file in
    let named = Tree.places text "Scc_certificate" in
    let of_invariants = Tree.places text "Scc_certificate.Invariant" in
    List.filter (fun place -> not (List.mem place of_invariants)) named
    |> List.map (fun place -> Printf.sprintf "%s, at character %d" file place)
  in
  List.concat_map of_file (sources search)
