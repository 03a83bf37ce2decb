(* Values of the interfaces in lib/ that no other module uses, by the typed trees of the compiler.

   unused.exe LIB BIN TEST

   The compiler reports a value that its own module does not use, unless the interface exports it. An exported
   value that only its own module uses need not be in the interface, and one that nobody uses need not exist.
   Tests count as users: some values are there to be examined. All values of a module that is an argument of a
   functor, is included or is packed count as used. So do those of a module with a functor whose result is
   included.

   Prints each unused value, and each exception that is not needed, and counts; exits with 1 if there is any. *)

open Typedtree

(* By file and name, with the reason. *)
let exceptions =
  [
    ("lib/language/syntax/parser.mli", "model", "Menhir's: the incremental entry of the same name is used");
    ("lib/language/syntax/parser.mli", "expression", "Menhir's: the incremental entry of the same name is used");
    ("lib/foundation/base/constant_stack.mli", "flatten", "hides that of Stdlib");
    ("lib/foundation/base/constant_stack.mli", "remove_assq", "hides that of Stdlib");
  ]

let name_of uid = Format.asprintf "%a" Types.Uid.print uid

(* Uses, by the identity that the compiler gives a value: a module and a number. The values of an implementation
   are numbered by themselves, so what a module says of its own is none of its interface. *)
let used : (string, unit) Hashtbl.t = Hashtbl.create 10_000

let use ~own (v : Types.value_description) =
  let name = name_of v.val_uid in
  if not (String.starts_with ~prefix:(own ^ ".") name) then Hashtbl.replace used name ()

let wholly_used : (string, unit) Hashtbl.t = Hashtbl.create 100

(* The module that has the functor. *)
let rec use_functor (f : module_expr) =
  match f.mod_desc with
  | Tmod_ident (Pdot (m, _), _) -> Hashtbl.replace wholly_used (Path.last m) ()
  | Tmod_constraint (f, _, _, _) -> use_functor f
  | _ -> ()

let rec use_all (m : module_expr) =
  match m.mod_desc with
  | Tmod_ident (path, _) -> Hashtbl.replace wholly_used (Path.last path) ()
  | Tmod_constraint (m, _, _, _) -> use_all m
  | Tmod_apply (f, _, _) -> use_functor f
  | _ -> ()

let uses ~own =
  let super = Tast_iterator.default_iterator in
  let expr self (e : expression) =
    (match e.exp_desc with
     | Texp_ident (_, _, v) -> use ~own v
     | Texp_letop { let_; ands; _ } -> List.iter (fun b -> use ~own b.bop_op_val) (let_ :: ands)
     | Texp_pack m -> use_all m
     | _ -> ());
    super.expr self e
  in
  let module_expr self (m : module_expr) =
    (match m.mod_desc with Tmod_apply (_, argument, _) -> use_all argument | _ -> ());
    super.module_expr self m
  in
  let structure_item self (i : structure_item) =
    (match i.str_desc with Tstr_include included -> use_all included.incl_mod | _ -> ());
    super.structure_item self i
  in
  { super with expr; module_expr; structure_item }

let declared = ref 0
let faults = ref 0
let excepted : (string * string * string, unit) Hashtbl.t = Hashtbl.create 10

let fault form =
  incr faults;
  Printf.printf form

let declare (v : value_description) =
  incr declared;
  let place = v.val_loc.loc_start and name = Ident.name v.val_id in
  if not (Hashtbl.mem used (name_of v.val_val.val_uid)) then
    let is_this (file, value, _) = String.equal file place.pos_fname && String.equal value name in
    match List.find_opt is_this exceptions with
    | Some exception_ -> Hashtbl.replace excepted exception_ ()
    | None -> fault "%s:%d: no other module uses %s\n" place.pos_fname place.pos_lnum name

(* What a module type lists is what others have to have. *)
let interface =
  let super = Tast_iterator.default_iterator in
  {
    super with
    value_description = (fun _ v -> declare v);
    module_type_declaration = (fun _ _ -> ());
  }

let () =
  let of_unit (cmt : Cmt_format.cmt_infos) = Trees.visit (uses ~own:cmt.cmt_modname) cmt in
  let of_folder folder = List.iter of_unit (Trees.read folder) in
  List.iter of_folder (List.tl (Array.to_list Sys.argv));
  let in_lib (cmt : Cmt_format.cmt_infos) =
    match cmt.cmt_annots with
    | Interface _ when not (Hashtbl.mem wholly_used (Trees.module_of cmt)) -> Trees.visit interface cmt
    | _ -> ()
  in
  List.iter in_lib (Trees.read Sys.argv.(1));
  let needless ((file, name, _) as exception_) =
    if not (Hashtbl.mem excepted exception_) then fault "%s: %s is no exception\n" file name
  in
  List.iter needless exceptions;
  Printf.printf "%d values of interfaces, %d faults\n" !declared !faults;
  if !declared = 0 || !faults > 0 then exit 1
