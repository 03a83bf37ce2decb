open Scc_base
open Scc_exact
open Scc_geometry
open Scc_concave
open Scc_verdicts
open Cmdliner

(* {1 Faults} *)

let union_command ~orient = "scc decompose --union" ^ if orient then " --orient" else ""

(* What an option mends is to be mended by that: the last of the faults says so. *)
let structure ~union ~given (set : Polyhedron.ifs) faults =
  let name array i = if i >= 0 && i < Array.length array then fst array.(i) else string_of_int i in
  let vertex = name set.ifs_vertices and face = name set.ifs_faces in
  let last = List.length faults - 1 in
  let cure = Several_solids.advice ?union:(if union then None else Some union_command) set in
  let tries = Mend_options.all_helping set faults in
  (* Welding may join what shares faces for good. *)
  let cure =
    match cure with
    | None when tries = [] && (not union) && given != set ->
      Option.map (( ^ ) "as they are in the file, ") (Several_solids.advice ~union:union_command given)
    | _ -> cure
  in
  let one i fault =
    let hint =
      match (Mend_options.helping set [ fault ], tries) with
      | _, _ when Option.is_some cure -> if i = last then cure else None
      | _, _ :: _ when i = last -> Some ("to mend it, add " ^ String.concat " " tries)
      | [], _ -> Polyhedron_fault.hint ~vertex ~face fault
      | _ -> None
    in
    Diag.error (Polyhedron_fault.code fault) Span.none ?hint "%s" (Polyhedron_fault.message ~vertex ~face fault)
  in
  List.mapi one faults

(* Solids with more parts take hours. *)
let greatest = 1_000_000

let diagnostics ~union ~given (set : Polyhedron.ifs) : Decomposed.fault -> Diag.t list = function
  | Unsound (Structure faults) -> structure ~union ~given set faults
  | fault ->
    let hint =
      match fault with
      | Pieces (Apart _ | Island _) ->
        Some "each of several solids needs a file of its own, or add --union for all of them"
      | Pieces (Outward _) -> Some "to mend it, add --orient"
      | Inside_out _ -> Some (Mend_options.of_inside_out set)
      | Nothing -> Some (Mend_options.of_nothing set)
      | Unsound (Cut _) when not union -> Some "if solids overlap there, add --union"
      | Too_many most when most < greatest -> Some "--parts sets how many there may be"
      | Unsound (Structure _ | Cut _) | Too_many _ -> None
    in
    let code, text = Decomposed.message set fault in
    [ Diag.error code Span.none ?hint "%s" text ]

(* {1 Report} *)

let most_listed = 40

(* Cuts through cuts have long numbers. *)
let short ?(most = 24) q = Decimal.in_short ~most q

let text ~name ~mended ~union (t : Parts.t) =
  let b = Buffer.create 1024 in
  Buffer.add_string b (Mend_options.text mended);
  let drawn = t.drawn in
  Printf.bprintf b "%s: %s, %s, volume %s\n" name
    (Plural.count (Array.length drawn.regions) "plane face" "plane faces")
    (Plural.count (Drawn.reflex_edges drawn) "reflex edge" "reflex edges")
    (short ~most:64 (Drawn.volume drawn.set));
  Printf.bprintf b "%s, %s%s\n" (Plural.count (Array.length t.parts) "convex part" "convex parts")
    (Plural.count (List.length t.joints) "joint" "joints")
    (if union then ", in " ^ Plural.count (Decomposed.groups t) "piece" "pieces" else "");
  let part k (name, (p : Polyhedron.t)) =
    if k < most_listed then
      Printf.bprintf b "  %s: %d corners, %d faces, volume %s\n" name (Array.length p.vertices)
        (Array.length p.faces)
        (short (Mass_properties.of_polyhedron p).volume)
  in
  Array.iteri part t.parts;
  let more = Array.length t.parts - most_listed in
  if more > 0 then Printf.bprintf b "  and %d more\n" more;
  Buffer.contents b

(* {1 The command} *)

let formats =
  [
    (".sc", fun ~path ~mass t -> Written_parts.compound ~name:(Scc_mesh.Written.name_of ~path) ~mass t);
    (".obj", fun ~path:_ ~mass:_ t -> Written_parts.obj t);
  ]

let writer path =
  let base = String.lowercase_ascii (Filename.basename path) in
  List.find_opt (fun (ending, _) -> Filename.check_suffix base ending) formats

let line : Decomposed.progress -> string = function
  | Looking faces -> "looking at " ^ Plural.count faces "face" "faces"
  | Uniting n -> "uniting: " ^ Plural.count n "pair of faces looked at" "pairs of faces looked at"
  | Cutting n -> "cutting: " ^ Plural.count n "cell looked at" "cells looked at"
  | Making (k, of_) -> Printf.sprintf "making part %d of %d" k of_
  | Naming left -> "naming faces: " ^ Plural.count left "part left" "parts left"

(* At most ten times a second. *)
let show console =
  let last = ref 0. in
  fun progress ->
    let now = Unix.gettimeofday () in
    if now -. !last >= 0.1 then begin
      last := now;
      Console.progress console (line progress)
    end

(* The mesh, what was done to it, and its parts. *)
let work console ~mend ~names ~union ~most path =
  let* source = Input.warned console path in
  let files = Input.beside console in
  let* given, warnings = Result.listed (Scc_mesh.Mesh.read ~files ~path (Source.text source)) in
  Console.report console warnings;
  let* set, mended = Mend_options.apply mend given in
  let set, mended =
    match Bent.triangulated set with
    | Some (set, line) -> (set, mended @ [ ("triangles", line) ])
    | None -> (set, mended)
  in
  let cut = if union then Decomposed.united else Decomposed.make in
  let* t = Result.map_error (diagnostics ~union ~given set) (cut ~progress:(show console) ~names ~most set) in
  Ok (t, mended)

let report console ~mended ~union ~mass output path (t : Parts.t) =
  let write () =
    match output with
    | None -> Ok ()
    | Some (path, write) ->
      let mass = match mass with Some m -> m | None -> Drawn.volume t.drawn.set in
      let text = write ~path ~mass t in
      Result.listed (Whole_file.with_file path (fun put -> put text))
  in
  let* () =
    Console.answer_and_write console write
      ~text:(fun () -> text ~name:(Visible.line path) ~mended ~union t)
      ~json:(fun () ->
          Scc_reports.Decomposition_json.document ~name:path ~exit:(Exit_code.to_int Holds)
            ~source:(Console.source console) ~diagnostics:(Console.kept console) ~mended t)
  in
  Ok Exit_code.Holds

let decompose console ~mend ~names ~union ~most ~bounds ~mass output path =
  let work () = work console ~mend ~names ~union ~most path in
  Bounded.within console bounds work (fun (t, mended) -> report console ~mended ~union ~mass output path t)

let run color json mend names union most bounds mass output path =
  let console = Console.make ~color ~json () in
  let outputs = Outputs.file ~over:(Some path) "-o" output in
  let go output =
    Guard.run ~outputs console (fun () -> decompose console ~mend ~names ~union ~most ~bounds ~mass output path)
  in
  match output with
  | None -> go None
  | Some file ->
    let find file = Option.map snd (writer file) in
    Guard.by_ending file ~endings:(List.map fst formats) ~what:"parts" find (fun output -> go (Some output))

let mesh =
  Options.argument 0 ~docv:"MESH" "A polyhedron file, in any format that $(b,scc shape) reads."

let output =
  Options.maybe Options.named [ "o"; "output" ] ~docv:"OUT"
    "Writes the parts to $(docv), exactly. The ending of the name selects the format: $(b,.sc), a compound of \
     the language with a template for each part, glued where they touch; or $(b,.obj), each part an object."

let mass =
  Options.maybe (Options.positive "mass") [ "mass" ] ~docv:"M"
    "The mass of the whole in $(b,-o) $(i,OUT).sc; its volume by default. Parts share it by their volumes."

let names =
  Options.flag [ "names" ]
    "Cuts parts further where one of their faces would lie in two faces of the solid, so that the name of a face \
     means that face. Without it, such a face has the name of one of them, and there are fewer parts."

let union =
  Options.flag [ "union" ]
    "Cuts the union of what the faces surround: solids of one file may overlap, share faces, or touch in edges \
     and corners, and need not be connected. A face that is left in pieces gives each a name, as \
     $(b,top), $(b,top_2)."

let most =
  Options.default
    (Options.integer ~least:1 ~most:greatest "number of parts")
    Decomposed.most_parts [ "parts" ] ~docv:"N"
    "The greatest number of parts. A solid that takes more, or more than twenty times as many cells on the way to \
     them, is refused (SC0111)."

let command =
  let exits =
    Exits.man () ~never:[ Violated; Undecided ]
      ~told:
        [
          (Holds, "if there are such parts."); (Invalid, "if the mesh bounds no solid, or cannot be read.");
          (Stopped, Bounded.exit);
        ]
  in
  Cmd.v
    (Cmd.info "decompose" ~doc:"cut a solid that is not convex into convex parts" ~man:Manual.decompose ~exits)
    Term.(
      const run $ Options.color $ Options.json $ Mend_options.term $ names $ union $ most $ Bounded.term
      $ mass $ output $ mesh)
