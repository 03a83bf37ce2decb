open Scc_base
open Scc_exact
open Scc_geometry
open Scc_concave
open Scc_verdicts
open Scc_snap
open Cmdliner

(* What the argument names: a file, or a template of one. A file whose name has a colon is a file. *)
let split argument =
  match String.rindex_opt argument ':' with
  | Some i when i > 0 && not (Sys.file_exists argument) ->
    (String.sub argument 0 i, Some (String.sub argument (i + 1) (String.length argument - i - 1)))
  | _ -> (argument, None)

let template console ~overrides path name =
  let* source = Input.warned console path in
  let* tree = Scc_notation.Notation.model source in
  let read_file = Input.mesh_reader console path in
  let asked_at = Span.command_line in
  let* set, warnings = Scc_elaborate.Template_set.find ~read_file ~overrides ~asked_at tree name in
  Console.report console warnings;
  Ok set

let mesh console path =
  let* source = Input.warned console path in
  let files = Input.beside console in
  let* set, warnings = Result.listed (Scc_mesh.Mesh.read ~files ~path (Source.text source)) in
  Console.report console warnings;
  Ok set

let templates_of console path =
  let* source = Input.warned console path in
  let* tree = Scc_notation.Notation.model source in
  let names = Scc_elaborate.Template_set.names tree in
  let hint =
    match List.partition (fun name -> String.contains name '(') names with
    | _, name :: _ -> Some (Printf.sprintf "name one of them: %s:%s" path name)
    | name :: _, [] ->
      Some (Printf.sprintf "name one of them, with numbers for what is in brackets: %s:%s" path name)
    | [], [] -> None
  in
  let list = match names with [] -> "it has no templates" | _ -> "its templates: " ^ String.concat ", " names in
  Error
    [
      Diag.error Code.wrong_kind Span.command_line ?hint
        "%s is a model (%s), and a single shape is needed here" path list;
    ]

let set console ~overrides argument =
  match split argument with
  | path, Some name -> template console ~overrides path name
  | path, None ->
    if Option.is_some (Scc_notation.Notation.of_name path) then templates_of console path else mesh console path

type options = {
  mend : Mend_options.t;
  round : bool;
  snap : Rat.t option;
  hull : bool;
  faces : int option;
  output : string option;
  svg : string option;
  page : string option;
  drawing : Scc_picture.Solid_picture.options;
}

(* {1 The solid that is meant} *)

let hull (set : Polyhedron.ifs) =
  match Scc_mesh.Hull_of.hull set with
  | Some hull -> Ok hull
  | None -> Error [ Diag.error Code.no_solid Span.none "all points are in one plane: they span no solid" ]

let around hull most =
  match Outer.of_hull ~faces:most hull with
  | Ok outer -> Ok outer
  | Error least ->
    Error
      [
        Diag.error Code.few_faces Span.none "no solid around the hull was found with so few of its faces"
          ~hint:(Printf.sprintf "--faces %d is enough" least);
      ]

let refused what (why, hint) =
  Error [ Diag.error Code.cannot_snap Span.none ?hint "%s cannot be snapped: %s" what why ]

let snap ~hull tolerance set =
  if hull then
    match Cloud.snap ~tolerance set with
    | Ok found -> Ok found
    | Error (refusal, set) ->
      let hint =
        "without --snap the hull is exact as it is, with more faces; a smaller distance merges fewer of them"
      in
      let why =
        match refusal with
        | Not_a_surface _ | Not_of_a_solid -> "the faces that are flat within that distance bound no solid"
        | Too_far _ | Not_found _ | Too_large -> fst (Snap.explain set ~tolerance refusal)
      in
      refused "the hull" (why, Some hint)
  else
    match Snap.snap ~tolerance set with
    | Ok found -> Ok found
    | Error refusal -> refused "this" (Snap.explain set ~tolerance refusal)

let too_fine set =
  if Polyhedron.too_fine set then
    Error
      [
        Diag.error Code.number_too_large Span.none "the common denominator of the coordinates is too large"
          ~hint:"use decimals, or fractions with few different denominators";
      ]
  else Ok ()

(* {1 Report} *)

let vertices n = Plural.count n "vertex" "vertices"

let snap_text ~gone (tolerance, (s : Snap.snapped)) =
  let moved = Array.fold_left (fun n d -> if Rat.sign d > 0 then n + 1 else n) 0 s.moved in
  let far = ref 0 in
  Array.iteri (fun v d -> if Rat.compare d s.moved.(!far) > 0 then far := v) s.moved;
  let short = Decimal.significant ~digits:3 in
  let over = if s.turned_over then "; all faces were turned over, as they were listed clockwise" else "" in
  let gone = if gone > 0 then Printf.sprintf "; without %s of the hull" (vertices gone) else "" in
  if moved = 0 then
    Printf.sprintf "snapped within %s: nothing moved, it is exact as it is%s\n" (short tolerance) gone
  else
    Printf.sprintf "snapped within %s: %s moved, %s the farthest, by %s; coordinates of at most %d bits%s%s\n"
      (short tolerance) (vertices moved)
      (fst s.set.ifs_vertices.(!far))
      (short s.moved.(!far)) s.bits over gone

let outer_text (o : Outer.t) =
  let faces = Array.length o.solid.ifs_faces in
  if faces = o.faces then Printf.sprintf "the hull has %d faces\n" faces
  else
    Printf.sprintf
      "simplified: %d faces for %d of the hull, which is inside, and beyond it by at most %s\n" faces o.faces
      (Decimal.significant_above ~digits:4 o.beyond)

(* What to try with a mesh of another program. *)
let advice (r : Solid_report.t) =
  match r.verdict with
  | Accepted _ -> ""
  | Rejected faults ->
    let line text = text ^ "\n" in
    let union ~orient = "scc decompose --union" ^ if orient then " --orient" else "" in
    let several = Option.fold ~none:"" ~some:line (Several_solids.advice ~union r.set) in
    if Flat_mesh.is_flat r.set then several
    else
      (* Welding makes nothing of solids that have vertices of their own. *)
      let apart = several <> "" && Scc_concave.Oriented.pieces r.set > 1 in
      let tries = if apart then [] else Mend_options.all_helping r.set faults in
      let bent = function Polyhedron_fault.Not_convex _ | Degenerate_face _ -> true | _ -> false in
      several
      ^ (if tries = [] then "" else line ("to mend it: scc shape " ^ String.concat " " tries))
      ^
      if List.exists bent faults then line "for convex parts of it: scc decompose; for its hull: scc shape --hull"
      else ""

let report console argument code ~mended ~gone ?snapped ?outer r write =
  let told =
    Mend_options.text mended
    ^ Option.fold ~none:"" ~some:outer_text outer
    ^ Option.fold ~none:"" ~some:(snap_text ~gone) snapped
  in
  let exit = Exit_code.to_int code in
  Console.answer_and_write console write
    ~text:(fun () -> told ^ Solid_report.to_text ~name:(Visible.line argument) r ^ advice r)
    ~json:(fun () ->
        Scc_reports.Shape_json.document ~name:argument ~exit ~source:(Console.source console)
          ~diagnostics:(Console.kept console) ~mended ?snap:snapped ?outer r)

let write console ~round output code set =
  match output with
  | Some written when Exit_code.equal code Exit_code.Holds -> Written_solid.convex console ~round written set
  | Some written -> Written_solid.concave console ~round written set
  | None -> Ok ()

let draw o ~name report =
  match o.svg with
  | None -> Ok ()
  | Some path ->
    let text = Scc_picture.Solid_picture.svg ~name o.drawing report in
    Result.listed (Whole_file.with_file path (fun put -> put text))

let show o ~name report =
  match o.page with
  | None -> Ok ()
  | Some path ->
    let page = Scc_view.Solid_page.write ~name report in
    Result.listed (Whole_file.with_file path page)

(* The solid that is meant, and all that is to be said of it. *)
let work console ~overrides o argument =
  let* set = set console ~overrides argument in
  let* () = too_fine set in
  let* set, mended = Mend_options.apply o.mend set in
  let* set = if o.hull then hull set else Ok set in
  let* outer =
    match o.faces with
    | None -> Ok None
    | Some most ->
      let faces = Plural.count (Array.length set.ifs_faces) "face" "faces" in
      Console.progress console ("simplifying a hull of " ^ faces);
      Scc_base.Memory.spare_runs ();
      Result.map Option.some (around set most)
  in
  let set = match outer with Some o -> o.solid | None -> set in
  let* snapped =
    match o.snap with
    | None -> Ok None
    | Some tolerance -> Result.map (fun s -> Some (tolerance, s)) (snap ~hull:o.hull tolerance set)
  in
  let corners = Array.length set.ifs_vertices in
  let set = match snapped with Some (_, s) -> s.set | None -> set in
  let gone = corners - Array.length set.ifs_vertices in
  Ok (mended, outer, snapped, gone, Solid_report.make set)

let conclude console o output argument (mended, outer, snapped, gone, (r : Solid_report.t)) =
  let code = if Solid_report.accepted r then Exit_code.Holds else Exit_code.Invalid in
  (* One output that cannot be written keeps the others from nothing. *)
  let write () =
    let shape = write console ~round:o.round output code r.set in
    let written = [ draw o ~name:argument r; show o ~name:argument r; shape ] in
    match List.concat_map (function Ok () -> [] | Error d -> d) written with
    | [] -> Ok ()
    | faults -> Error faults
  in
  let* () = report console argument code ~mended ~gone ?snapped ?outer r write in
  Ok code

let shape console ~overrides ~bounds o output argument =
  let work () = work console ~overrides o argument in
  Bounded.within console bounds work (conclude console o output argument)

let run color json overrides o bounds argument =
  let console = Console.make ~color ~json () in
  let outputs =
    (* A mesh is rewritten in place, and a model is not. *)
    let over = match split argument with path, None -> Some path | _, Some _ -> None in
    Outputs.file ~over "-o" o.output @ Outputs.file "--svg" o.svg @ Outputs.file "--view" o.page
  in
  let go output = Guard.run ~outputs console (fun () -> shape console ~overrides ~bounds o output argument) in
  match o.output with
  | _ when (match o.snap with Some t -> Rat.sign t <= 0 | None -> false) ->
    Guard.usage "the distance of --snap is to be greater than 0"
  | _ when Option.is_some o.faces && not o.hull -> Guard.usage "--faces tells how many faces --hull may have"
  | _ when Option.is_some o.faces && Option.is_some o.snap ->
    Guard.usage "--faces and --snap do not go together: both choose the planes of faces"
  | None when o.round -> Guard.usage "--round tells how -o writes"
  | None -> go None
  | Some path ->
    let find path = Scc_mesh.Written.to_file ~path in
    Guard.by_ending path ~endings:Scc_mesh.Written.endings ~what:"shapes" find (fun output -> go (Some output))

let argument =
  let formats = Scc_mesh.Mesh.formats in
  let format name =
    let endings = List.filter (fun (_, other) -> String.equal other name) formats in
    Printf.sprintf "%s (%s)" name (String.concat ", " (List.map (fun (e, _) -> "$(b," ^ e ^ ")") endings))
  in
  let first names (_, (name : string)) = if List.mem name names then names else names @ [ name ] in
  let formats = List.map format (List.fold_left first [] formats) in
  let doc =
    Printf.sprintf
      "A polyhedron file, or $(i,MODEL):$(i,TEMPLATE), a template of a model. Formats of polyhedra, whose \
       coordinates are read exactly: %s. A file of another extension is recognized by its first bytes."
      (String.concat ", " formats)
  in
  Arg.(required & pos 0 (some string) None & info [] ~docv:"FILE" ~doc)

let snap_option =
  Options.maybe Options.rational [ "snap" ] ~docv:"DISTANCE"
    "Makes the solid exact: finds a convex closed polyhedron with the same vertices, faces and names, no vertex \
     of which is farther than $(docv) from its original place, and prints how far they moved. For solids with \
     rounded decimals, so that the corners of faces are not quite in one plane."

let hull_option =
  Options.flag [ "hull" ]
    "Takes the convex hull of the vertices, exactly, whatever the faces of $(i,FILE) are; it may be a cloud of \
     points. With $(b,--snap), neighbouring faces that are flat within the distance become one face, whose \
     corners are moved into one plane, so that rounded points give the original solid. No point is farther than \
     the distance in front of a face."

let faces_option =
  let least = 4 and most = 1000 in
  let doc =
    Printf.sprintf
      "A solid of at most $(docv) faces, from %d to %d, that contains the $(b,--hull), and so all points. It has \
       faces of the hull, in directions rounded to some fifteen bits, chosen such that leaving one out would \
       enlarge the solid most; each touches the hull. The report has the greatest distance of a point of the \
       solid from the hull. Not with $(b,--snap)."
      least most
  in
  let parse s =
    match int_of_string_opt s with
    | Some n when n >= least && n <= most -> Ok n
    | _ -> Error (`Msg (Printf.sprintf "`%s' is no number from %d to %d" s least most))
  in
  let number = Arg.conv ~docv:"N" (parse, Format.pp_print_int) in
  Arg.(value & opt (some number) None & info [ "faces" ] ~docv:"N" ~doc)

let output =
  Options.maybe Options.named [ "o"; "output" ] ~docv:"OUT"
    "Writes the shape to $(docv), exactly, if it is accepted. A refused shape is written too if its faces bound \
     a solid: closed, in one piece, and without cutting each other, but not convex, or with faces that \
     $(b,--merge) would join. The report says so, and the exit code is still that of a refused shape; $(b,scc \
     decompose) reads such a file, and so does $(b,decompose \"OUT\") in a model. The ending of the name selects \
     the format: $(b,.off), $(b,.obj) (which keeps the names of faces), $(b,.stl), $(b,.ply), or $(b,.sc), a \
     template for a model, or a compound. Coordinates are decimals. A number without a decimal, such as 1/3, is \
     a fraction p/q, which other programs may not read; STL and PLY are then not written."

let round =
  Options.flag [ "round" ]
    "Rounds the coordinates in the output of $(b,-o) to the nearest 64-bit numbers, for other programs; the \
     report says how many changed and by how much at most."

let svg =
  Options.maybe Options.named [ "svg" ] ~docv:"PICTURE"
    "Draws the shape into $(docv), from two opposite sides, with the names of its faces and vertices. For a \
     refused shape it shows the witness of each fault, and of each condition of Definition 4.3 that fails, at \
     its place. Hidden surfaces are computed exactly; places in the picture are rounded."

let page =
  Options.maybe Options.named [ "view" ] ~docv:"PAGE"
    "Writes a page to $(docv), one file of HTML that opens in a browser from disk. It shows the shape in space, \
     with the names and exact places of its faces, edges and vertices, and each fault at its place, as for \
     $(b,--svg)."

let drawn =
  let one svg drawing =
    match svg with
    | None when Picture_options.given drawing -> Error "--from, --up and --width tell how --svg draws"
    | _ -> Ok (svg, Picture_options.of_solid drawing)
  in
  Term.(term_result' ~usage:true (const one $ svg $ Picture_options.term))

let options =
  let make mend round snap hull faces output page (svg, drawing) =
    { mend; round; snap; hull; faces; output; svg; page; drawing }
  in
  Term.(const make $ Mend_options.term $ round $ snap_option $ hull_option $ faces_option $ output $ page $ drawn)

let command =
  let exits =
    Exits.man () ~never:[ Violated; Undecided ]
      ~told:
        [
          (Holds, "if the shape is accepted."); (Invalid, "if it is not, or cannot be read.");
          (Stopped, Bounded.exit);
        ]
  in
  Cmd.v
    (Cmd.info "shape" ~doc:"report on a polyhedron" ~man:Manual.shape ~exits)
    Term.(
      const run $ Options.color $ Options.json $ Options.overrides $ options $ Bounded.term $ argument)
