open Scc_exact
open Scc_geometry
open Scc_mesh

type t = { grid : Rat.t option; weld : bool; orient : bool; merge : bool }

(* Boxes do not tell which piece is a hollow of another one. *)
let in_each_other set line =
  match Shells.oriented set with
  | set, [] -> (set, line)
  | set, turned ->
    let names = List.map (fun f -> fst set.Polyhedron.ifs_faces.(f)) turned in
    let over = "; then turned over, by what is within what: the pieces of " in
    (set, line ^ over ^ String.concat ", " names)

let apply o set =
  let step wanted by f (set, told) =
    if wanted then
      let set, line = f set in
      (set, (by, line) :: told)
    else (set, told)
  in
  let start = match o.grid with Some d -> step true "grid" (Mend.on_grid d) (set, []) | None -> (set, []) in
  let set, told = step o.weld "weld" Mend.weld start in
  let oriented =
    if not o.orient then Ok (set, told)
    else
      Result.map
        (fun (set, line) ->
           let set, line = in_each_other set line in
           (set, ("orient", line) :: told))
        (Mend.orient set)
  in
  Result.map
    (fun done_ ->
       let set, told = step o.merge "merge" Mend.merge done_ in
       (set, List.rev told))
    oriented

(* Each trial looks at all faces. *)
let most_tried = 100_000

let to_be_closed (set : Polyhedron.ifs) faults =
  let opened = function Polyhedron_fault.Open_edge _ -> true | _ -> false in
  Array.length set.ifs_faces <= most_tried && List.exists opened faults

let closing set faults = if to_be_closed set faults then Mend.closing_grid set else None
let merging set faults = if to_be_closed set faults then Mend.closing_merge set else None
