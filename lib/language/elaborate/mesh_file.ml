open Scc_base
open Scc_syntax
open Scc_concave
open Scc_snap

let file report read_file (path : string Ast.loc) =
  match read_file path.it with
  | Error why ->
    Report.error report Code.cannot_read path.at "cannot read the mesh `%s`: %s" path.it why;
    None
  | Ok text -> (
      let add (d : Diag.t) =
        let notes = if Span.is_none d.span then [] else [ (path.at, "the mesh is used here") ] in
        let span = if Span.is_none d.span then path.at else d.span in
        Report.add report { d with span; notes = d.notes @ notes }
      in
      match Scc_mesh.Mesh.read ~files:read_file ~path:path.it text with
      | Ok (set, warnings) ->
        List.iter add warnings;
        Some set
      | Error d ->
        add d;
        None)

let snapped report (path : string Ast.loc) set tolerance =
  match Snap.snap ~tolerance set with
  | Ok found -> Some found.set
  | Error refusal ->
    let why, hint = Snap.explain set ~tolerance refusal in
    Report.error report Code.cannot_snap path.at ?hint "the mesh `%s` cannot be snapped: %s" path.it why;
    None

let mended report (path : string Ast.loc) set mending =
  match Mended.apply mending set with
  | Ok (set, _) -> Some set
  | Error why ->
    Report.error report Code.overused_edge path.at "the faces of the mesh `%s` cannot be oriented: %s" path.it why;
    None

let flat report (path : string Ast.loc) set =
  match Bent.triangulated set with
  | None -> set
  | Some (flat, line) ->
    Report.warning report Code.mesh_nearly path.at "%s" line;
    flat

(* Faces that surround nothing stay as they are, so that their faults are found where those of all shapes are. *)
let union_hint set (m : Ast.mending) (fault : Decomposed.fault) =
  match fault with
  | Inside_out _ when (not m.weld) && Oriented.pieces set = 0 ->
    Some "write `weld` and `orient` after the file: faces that share vertices are turned over to look outward"
  | Inside_out { whole = true; _ } when not m.orient ->
    Some "write `orient` after the file: faces are turned over so that all look out of the solid"
  | Nothing when (not m.weld) && Mended.one_side_each set ->
    Some "write `weld` after the file: each face is there from both sides, and one of them stays"
  | _ -> None

let united report (path : string Ast.loc) m set =
  let set = flat report path set in
  match Decomposed.united set with
  | Ok union ->
    let whole = Decomposed.convex_whole union in
    if Option.is_none whole then
      Report.error report Code.not_convex path.at "the union of what is in the mesh `%s` is not convex" path.it
        ~hint:"a compound = decompose \"file\" union cuts it into convex parts";
    whole
  | Error (Unsound (Structure _)) -> Some set
  | Error fault ->
    let code, text = Decomposed.message set fault in
    Report.error report code path.at ?hint:(union_hint set m fault) "%s" text;
    None

let read report env ~read_file (path : string Ast.loc) (m : Ast.mending) =
  let path = { path with it = Env.beside env path.it } in
  let set = file report read_file path in
  let length what = function
    | None -> Some None
    | Some e -> Option.map Option.some (Constant.positive report env what e)
  in
  let grid = length "distance of the grid" m.grid and tolerance = length "distance to snap" m.snap in
  let*? set = set in
  let*? grid = grid in
  let*? tolerance = tolerance in
  let*? set = mended report path set { grid; weld = m.weld; orient = m.orient; merge = m.merge } in
  let*? set = match tolerance with None -> Some set | Some tolerance -> snapped report path set tolerance in
  if m.union then united report path m set else Some set
