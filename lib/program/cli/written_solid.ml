open Scc_base
open Scc_exact
open Scc_geometry
open Scc_concave

type output = string * (Polyhedron.ifs -> (string, string) result)

let ends_in ending path = Filename.check_suffix (String.lowercase_ascii path) ending

(* In the language only convex solids are templates, and others are cut into parts where they are used. *)
let text (path, write) set =
  if Result.is_ok (Polyhedron.of_ifs set) then write set
  else if ends_in ".sc" path then Ok (Scc_mesh.Written.drawn ~path set)
  else write set

let texts ~hint outputs =
  let one (((path, _) as output), set) =
    match text output set with
    | Ok text -> Ok (path, text)
    | Error vertex ->
      Error
        [
          Diag.error Code.cannot_write (Span.of_file path) ~hint
            "the coordinates of %s are no decimals, and files of this format have no fractions" vertex;
        ]
  in
  Result.all one outputs

let write files =
  Result.listed (Whole_file.write (List.map (fun (path, text) -> (path, fun put -> put text)) files))

let put ~hint outputs =
  let* files = texts ~hint outputs in
  write files

let drawn = put

let templates ~hint path outputs =
  let* files = texts ~hint outputs in
  write [ (path, String.concat "\n" (List.map snd files)) ]

let hint = "with --round they are rounded to 64-bit numbers; .off and .obj keep fractions"

(* What is written is then not quite what is reported on, and that is told. *)
let rounded console ~round path set =
  if not round then Ok set
  else
    match Scc_mesh.Written.rounded set with
    | None ->
      let at = Span.of_file path in
      Error [ Diag.error Code.cannot_write at "a coordinate is beyond the greatest 64-bit number" ]
    | Some (set, 0, _) -> Ok set
    | Some (set, moved, most) ->
      Console.note console
        (Printf.sprintf "%s: rounded: coordinates changed: %d, by at most %s; faces may not be quite flat" path
           moved
           (Decimal.significant_above ~digits:3 most));
      Ok set

let convex console ~round ((path, _) as output) set =
  let* set = rounded console ~round path set in
  put ~hint [ (output, set) ]

let concave console ~round ((path, _) as output) set =
  if Result.is_error (Decomposed.surface set) then Ok ()
  else
    (* The corners of a convex face make triangles in their order, and those of others do not. *)
    let set = if ends_in ".stl" path then Triangles.make set else set in
    let* set = rounded console ~round path set in
    let* () = put ~hint [ (output, set) ] in
    let what =
      if Result.is_error (Decomposed.surface set) then "and rounded no solid that can be cut"
      else if ends_in ".sc" path then "but a solid: a compound, which is cut where it is used"
      else Printf.sprintf "but a solid: scc decompose takes it, and in a model decompose \"%s\"" path
    in
    Console.note console (Printf.sprintf "%s: not a convex polyhedron, %s" path what);
    Ok ()
