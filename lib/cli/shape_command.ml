open Scc_base
open Scc_geometry
open Scc_session
open Cmdliner

let ( let* ) = Result.bind

(* What the argument names: a file, or a template of one. A file whose name has a colon is a file. *)
let split argument =
  match String.rindex_opt argument ':' with
  | Some i when i > 0 && not (Sys.file_exists argument) ->
    (String.sub argument 0 i, Some (String.sub argument (i + 1) (String.length argument - i - 1)))
  | _ -> (argument, None)

let template console ~overrides path name =
  let* source = Input.text console path in
  let* tree = (Front_end.of_source source).model source in
  let read_file = Input.mesh_reader console path in
  Scc_elaborate.Template_set.find ~read_file ~overrides ~asked_at:Span.command_line tree name

let mesh console path =
  let* source = Input.text console path in
  Result.map_error (fun d -> [ d ]) (Scc_mesh.Mesh.read ~path (Source.text source))

let templates_of console path =
  let* source = Input.text console path in
  let* tree = (Front_end.of_source source).model source in
  let names = Scc_elaborate.Template_set.names tree in
  let hint = Printf.sprintf "name one of them: %s:%s" path (match names with n :: _ -> n | [] -> "NAME") in
  let list = match names with [] -> "no templates" | _ -> String.concat ", " names in
  Error
    [
      Diag.error Code.wrong_kind Span.command_line ~hint
        "%s is a model (its templates: %s), and a single shape is needed here" path list;
    ]

let set console ~overrides argument =
  match split argument with
  | path, Some name -> template console ~overrides path name
  | path, None ->
    if Front_end.has_extension path then templates_of console path else mesh console path

let report console argument (set : Polyhedron.ifs) =
  let r = Solid_report.make set in
  let code = if Solid_report.accepted r then Exit_code.Holds else Exit_code.Invalid in
  Console.answer console
    ~text:(fun () -> Solid_report.to_text ~name:argument r)
    ~json:(fun () -> Scc_exchange.Shape_json.document ~name:argument ~exit:(Exit_code.to_int code) r);
  code

let run color json overrides argument =
  let console = Console.make ~color ~json in
  Guard.run console (fun () ->
      Result.map (report console argument) (set console ~overrides argument))

let argument =
  let formats = Scc_mesh.Mesh.formats in
  let format name =
    let endings = List.filter (fun (_, other) -> String.equal other name) formats in
    Printf.sprintf "%s (%s)" name (String.concat ", " (List.map (fun (e, _) -> "$(b," ^ e ^ ")") endings))
  in
  let first names (_, name) = if List.mem name names then names else names @ [ name ] in
  let formats = List.map format (List.fold_left first [] formats) in
  let doc =
    Printf.sprintf
      "A polyhedron file, or $(i,MODEL):$(i,TEMPLATE), a template of a model. Formats of polyhedra, whose \
       coordinates are read exactly: %s. A file of another extension is recognized by its first bytes."
      (String.concat ", " formats)
  in
  Arg.(required & pos 0 (some string) None & info [] ~docv:"FILE" ~doc)

let man =
  [
    `S Manpage.s_description;
    `P
      "Reports on a polyhedron. Two verdicts are told apart: whether it is a convex closed polyhedron, which \
       is what a template has to be, with every fault; and each of the seven conditions of Definition 4.3 as \
       printed, with a witness where it fails. Then the numbers of vertices, edges and faces and, of an \
       accepted shape, the exact volume, centroid and inertia.";
  ]
  @ Options.diagnostics_man
  @ [
    `S Manpage.s_examples;
    `Pre "  scc shape dodecahedron.off";
    `Pre "  scc shape specs/models/hexokinase.sc:Cube --json";
  ]

let command =
  let exits =
    Exits.man () ~never:[ Violated; Undecided ]
      ~told:[ (Holds, "if the shape is accepted."); (Invalid, "if it is not, or cannot be read.") ]
  in
  Cmd.v
    (Cmd.info "shape" ~doc:"report on a polyhedron" ~man ~exits)
    Term.(const run $ Options.color $ Options.json $ Options.overrides $ argument)
