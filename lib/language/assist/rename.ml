open Scc_base
open Scc_syntax
open Scc_describe

type edit = Span.t * string

let in_order edits = List.sort (fun ((a : Span.t), _) ((b : Span.t), _) -> Int.compare a.start b.start) edits

let apply text edits =
  let b = Buffer.create (String.length text + 64) in
  let from =
    List.fold_left
      (fun from ((at : Span.t), put) ->
         Buffer.add_substring b text from (Int.max 0 (at.start - from));
         Buffer.add_string b put;
         at.stop)
      0 (in_order edits)
  in
  Buffer.add_substring b text from (String.length text - from);
  Buffer.contents b

let name_fault name =
  let no_name =
    let rule = "a name is an ASCII letter, and letters, digits, `_` and `'` after it" in
    Some (Printf.sprintf "`%s` is no name: %s" name rule)
  in
  let begins = name <> "" && match name.[0] with 'a' .. 'z' | 'A' .. 'Z' -> true | _ -> false in
  match (Tokens.read (Source.make ~name:"name" name)).tokens with
  | [| { token = NAME n; start = 0; stop; _ }; _ |] 
    when begins && String.equal n name && stop = String.length name ->
    None
  | [| { token = BARRED _ | NUMBER _ | STRING _; _ }; _ |] | [||] | [| _ |] ->
    no_name
  | [| { start = 0; stop; _ }; _ |] when stop = String.length name && Tokens.is_word name ->
    Some (Printf.sprintf "`%s` is a word of the language and cannot be a name" name)
  | _ -> no_name

let line source (at : Span.t) = fst (Source.position source at.start)

(* {1 Names that are taken} *)

let tables (all : Declared.all) = [ all.bodies; all.behaviours; all.templates; all.values; all.modules ]

(* The declarations whose names stand beside that of an inner one: the corners and faces of its shape, say. *)
let beside (all : Declared.all) offset =
  let is_it (d : Declared.t) = Int.equal d.name.at.start offset in
  let owner _ (d : Declared.t) found = if List.exists is_it d.inner then d.inner @ found else found in
  Hashtbl.fold owner all.items []

let has name (d : Declared.t) = String.equal d.name.it name

(* Checks have names of their own. *)
let other_check (all : Declared.all) name =
  let is_it _ (d : Declared.t) found = if d.kind = Check && has name d then Some d else found in
  Hashtbl.fold is_it all.items None

let taken (uses : Uses.t) target name =
  let globally () = List.find_map (fun table -> List.nth_opt (Declared.find table name) 0) (tables uses.all) in
  match (target : Names.target) with
  | Channel _ ->
    (match Uses.channel uses name with [] -> None | c :: _ -> Some c.at)
  | Here offset -> (
      let place (d : Declared.t) = d.name.at in
      match (beside uses.all offset, Hashtbl.find_opt uses.all.items offset) with
      | (_ :: _ as others), _ -> Option.map place (List.find_opt (has name) others)
      | [], Some { kind = Model; _ } -> None
      | [], Some { kind = Check; _ } -> Option.map place (other_check uses.all name)
      | [], Some _ -> Option.map place (globally ())
      | [], None -> None)
  | There _ -> Option.map (fun (d : Declared.t) -> d.name.at) (globally ())
  | Several _ -> None

(* {1 The same meaning afterwards} *)

(* Where an offset of the old text is in the new one. *)
let shifted edits =
  let edits = Array.of_list (in_order edits) in
  let total = ref 0 in
  let after =
    Array.map
      (fun ((at : Span.t), put) ->
         total := !total + String.length put - (at.stop - at.start);
         (at.start, !total))
      edits
  in
  fun offset ->
    let rec search low high =
      if low >= high then low
      else
        let middle = (low + high) / 2 in
        if fst after.(middle) < offset then search (middle + 1) high else search low middle
    in
    match search 0 (Array.length after) with 0 -> offset | i -> offset + snd after.(i - 1)

let moved shift old name : Names.target -> Names.target = function
  | Here o -> Here (shift o)
  | Several os -> Several (List.map shift os)
  | t when Names.same t old -> (
      match t with
      | Channel _ -> Channel name
      | There t -> There { t with name }
      | Here _ | Several _ -> t)
  | t -> t

(* The first name that would mean something else. *)
let changed (r : Reading.t) edits old name =
  let shift = shifted edits in
  let text = apply (Source.text r.source) edits in
  let again = Reading.make (Source.make ~name:(Source.name r.source) text) in
  let rec compare (before : Names.occurrence list) (after : Names.occurrence list) =
    match (before, after) with
    | [], [] -> None
    | b :: before, a :: after ->
      (* a co-name with a bar becomes a mark and a name: its place moves by the mark *)
      let near = a.at.start - shift b.at.start in
      if near >= 0 && near <= 1 && Names.same (moved shift old name b.target) a.target then compare before after
      else Some b.at
    | b :: _, [] -> Some b.at
    | [], a :: _ -> Some a.at
  in
  compare (Names.all r) (Names.all again)

(* {1 Edits} *)

let edit name (r : Reading.t) (o : Names.occurrence) =
  let written = String.sub (Source.text r.source) o.at.start (o.at.stop - o.at.start) in
  match o.target with
  | Channel c when not (String.equal c written) -> (o.at, "~" ^ name)
  | _ -> (o.at, name)

let whole (r : Reading.t) =
  match Scc_notation.Notation.model r.source with
  | Ok _ -> Ok ()
  | Error [] -> Ok ()
  | Error (d :: _) ->
    let at = line r.source d.span in
    Error (Printf.sprintf "the text has an error in line %d, so not all places of the name are known" at)

let edits (r : Reading.t) (target : Names.target) name =
  let* () = Option.fold ~none:(Ok ()) ~some:Result.error (name_fault name) in
  let* () = whole r in
  let all = Names.all r in
  let unclear (o : Names.occurrence) =
    match (o.target, target) with Several os, Here offset -> List.mem offset os | _ -> false
  in
  match (target, List.find_opt unclear all) with
  | Several _, _ -> Error "several declarations may be meant here, so it cannot be renamed"
  | There { name = ""; _ }, _ -> Error "a module is called as its file: give it another name with `as`"
  | _, Some o ->
    Error
      (Printf.sprintf "the name in line %d may be that of another shape, so it cannot be renamed"
         (line r.source o.at))
  | (Here _ | Channel _ | There _), None -> (
      let found = List.filter (fun (o : Names.occurrence) -> Names.same o.target target) all in
      let edits = List.map (edit name r) found in
      match taken (Lazy.force r.uses) target name with
      | Some at -> Error (Printf.sprintf "the name `%s` is taken in line %d" name (line r.source at))
      | None -> (
          match changed r edits target name with
          | None -> Ok edits
          | Some at ->
            Error
              (Printf.sprintf "with the name `%s`, what stands in line %d would mean something else" name
                 (line r.source at))))
