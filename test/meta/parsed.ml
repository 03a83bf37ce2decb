open Parsetree

(* Those that people write: a parser, its messages and a lexer are made of other files. *)
let sources () =
  let is_made file =
    let base = Filename.chop_suffix file ".ml" in
    Filename.check_suffix base "_messages" || Tree.exists (base ^ ".mly") || Tree.exists (base ^ ".mll")
  in
  List.filter (fun file -> Filename.check_suffix file ".ml" && not (is_made file)) (Tree.files "lib")

let parsed file =
  let lexbuf = Lexing.from_string (Tree.read file) in
  Lexing.set_filename lexbuf file;
  Parse.implementation lexbuf

(* Constructors of functions differ between versions of the parser; what is printed does not. *)
let is_function e =
  let text = Format.asprintf "%a" Pprintast.expression e in
  List.exists (fun start -> Tree.starts_with start text) [ "fun "; "function"; "(fun "; "(function" ]

let name_of binding =
  match binding.pvb_pat.ppat_desc with
  | Ppat_var { txt; _ } | Ppat_constraint ({ ppat_desc = Ppat_var { txt; _ }; _ }, _) -> txt
  | _ -> "_"

(* {1 Length} *)

let lines (loc : Location.t) = loc.loc_end.pos_lnum - loc.loc_start.pos_lnum + 1

let longest ~most =
  let found = ref [] in
  let value_binding (it : Ast_iterator.iterator) b =
    let n = lines b.pvb_loc in
    if n > most && is_function b.pvb_expr then begin
      let at = b.pvb_loc.loc_start in
      found := Printf.sprintf "%s:%d: %s has %d lines" at.pos_fname at.pos_lnum (name_of b) n :: !found
    end;
    Ast_iterator.default_iterator.value_binding it b
  in
  let iterator = { Ast_iterator.default_iterator with value_binding } in
  List.iter (fun file -> iterator.structure iterator (parsed file)) (sources ());
  List.rev !found

(* {1 State} *)

let makes_state (f : Longident.t) =
  match f with
  | Lident "ref" -> true
  | Ldot (Lident ("Array" | "Bytes" | "Atomic" | "Weak"), ("make" | "init" | "make_matrix")) -> true
  | Ldot (_, "create") -> true
  | _ -> false

(* The field names of each record type that has a mutable one. *)
let mutable_records structure =
  let found = ref [] in
  let type_kind (it : Ast_iterator.iterator) kind =
    (match kind with
     | Ptype_record labels when List.exists (fun l -> l.pld_mutable = Asttypes.Mutable) labels ->
       found := List.map (fun l -> l.pld_name.Location.txt) labels :: !found
     | _ -> ());
    Ast_iterator.default_iterator.type_kind it kind
  in
  let iterator = { Ast_iterator.default_iterator with type_kind } in
  iterator.structure iterator structure;
  !found

let starts_as_function text e =
  let first = e.pexp_loc.loc_start.pos_cnum in
  let rest = String.sub text first (Int.min 16 (String.length text - first)) in
  let starts = [ "fun "; "function"; "(fun "; "(function"; "lazy"; "(lazy" ] in
  List.exists (fun start -> Tree.starts_with start rest) starts

(* Whether evaluating this makes something that can change; what functions make later does not count. *)
let changes text records e =
  let found = ref false in
  let given fields = List.map (fun ((field : Longident.t Location.loc), _) -> Longident.last field.txt) fields in
  let is_mutable fields ~whole record =
    List.for_all (fun name -> List.mem name record) (given fields)
    && (List.length fields = List.length record || not whole)
  in
  let expr (it : Ast_iterator.iterator) e =
    (match e.pexp_desc with
     | Pexp_apply ({ pexp_desc = Pexp_ident { txt; _ }; _ }, _) when makes_state txt -> found := true
     | Pexp_array (_ :: _) -> found := true
     | Pexp_record (fields, other) when List.exists (is_mutable fields ~whole:(other = None)) records ->
       found := true
     | _ -> ());
    if not (starts_as_function text e) then Ast_iterator.default_iterator.expr it e
  in
  let value_binding (it : Ast_iterator.iterator) b = if not (is_function b.pvb_expr) then it.expr it b.pvb_expr in
  let iterator = { Ast_iterator.default_iterator with expr; value_binding } in
  iterator.expr iterator e;
  !found

let state_of file =
  let text = Tree.read file and structure = parsed file in
  let records = mutable_records structure and found = ref [] in
  let value_binding _ b =
    if changes text records b.pvb_expr && not (is_function b.pvb_expr) then found := name_of b :: !found
  in
  let iterator = { Ast_iterator.default_iterator with value_binding } in
  iterator.structure iterator structure;
  let home = String.sub (Filename.chop_suffix file ".ml") 4 (String.length file - 7) in
  List.rev_map (fun name -> (home, name)) !found

let state () = List.concat_map state_of (sources ())

let list = "test/meta/state.txt"

(* The file and the name of each line; a line without a reason has neither. *)
let listed line =
  match List.filter (( <> ) "") (String.split_on_char ' ' line) with
  | home :: name :: _ :: _ -> (home, name)
  | _ -> ("", line)

let unlisted_state () =
  let is_entry line = line <> "" && line.[0] <> '#' in
  let lines = List.filter is_entry (String.split_on_char '\n' (Tree.read list)) in
  let found = state () and listed = List.map listed lines in
  let beyond others what = List.filter (fun one -> not (List.mem one others)) what in
  let fault why (home, name) = Printf.sprintf "%s %s: %s" home name why in
  List.map (fault ("it is not in " ^ list)) (beyond listed found)
  @ List.map (fault ("no such state, or no reason in " ^ list)) (beyond found listed)
