(* Polymorphic comparison and hashing in lib/, by the typed trees of the compiler.

   structural.exe LIB

   Stdlib's [=], [compare], [List.mem], [Hashtbl.hash] and their like compare by structure. That is right for plain
   data: machine integers, booleans, characters, strings, and tuples, lists, options, arrays, variants and records
   of these. Of any other type it is a fault, which the compiler does not report: functions cannot be compared, a
   cache inside a value becomes part of it, and the order of rationals is not that of their structure. Such types
   have functions of their own. A function that is polymorphic hides what it compares, and is refused as well. One
   use is always right: comparing with a constant constructor, as in [l = []] and [o = None], which looks at no
   structure.

   Prints each use of another type, and counts; exits with 1 if there is any. *)

open Typedtree

(* {1 Types as they are printed}

   The compiler's own representation of types changes from version to version, and its printed form does not. *)

type ty = Name of string * ty list | Tuple of ty list | Other

let tokens text =
  let word = Str.regexp "[A-Za-z_'.0-9/]+\\|->\\|[()*,]" in
  let rec from i found =
    match Str.search_forward word text i with
    | exception Not_found -> List.rev found
    | k ->
      let gap = String.trim (String.sub text i (k - i)) in
      let token = Str.matched_string text in
      let next = Str.match_end () in
      from next (token :: (if gap = "" then found else "?" :: found))
  in
  from 0 []

(* A type, and the tokens after it. *)
let rec parse tokens =
  let first, rest = applied tokens in
  let rec more parts = function
    | "*" :: rest ->
      let part, rest = applied rest in
      more (part :: parts) rest
    | rest -> ((match parts with [ one ] -> one | _ -> Tuple (List.rev parts)), rest)
  in
  more [ first ] rest

and applied = function
  | "(" :: rest ->
    let arguments, rest = arguments [] rest in
    (match (arguments, rest) with
     | [ one ], (")" | "," | "*" | "->") :: _ | [ one ], [] -> (one, rest)
     | _, name :: rest when is_name name -> postfix (Name (name, arguments)) rest
     | _ -> (Other, rest))
  | name :: rest when is_name name -> postfix (Name (name, [])) rest
  | _ :: rest -> (Other, rest)
  | [] -> (Other, [])

and postfix ty = function
  | name :: rest when is_name name -> postfix (Name (name, [ ty ])) rest
  | rest -> (ty, rest)

and arguments found tokens =
  let ty, rest = parse tokens in
  let ty, rest = match rest with "->" :: rest -> (Other, snd (parse rest)) | _ -> (ty, rest) in
  match rest with
  | "," :: rest -> arguments (ty :: found) rest
  | ")" :: rest -> (List.rev (ty :: found), rest)
  | _ -> ([ Other ], rest)

and is_name token = match token.[0] with 'a' .. 'z' | 'A' .. 'Z' | '_' | '\'' -> true | _ -> false

let printed type_expr =
  Str.global_replace (Str.regexp "[ \n]+") " " (Format.asprintf "%a" Printtyp.type_expr type_expr)

(* {1 Declared types} *)

type declared = Made_of of ty list  (** a variant, a record or another name of a type *) | Opaque

let types : (string, declared) Hashtbl.t = Hashtbl.create 1000

(* Module and type: what tells types apart, however long the path by which one is printed. *)
let key ~inside path =
  (* a name that is hidden by a later one is printed with a number: t/2 *)
  let path = Str.global_replace (Str.regexp "/[0-9]+") "" path in
  let parts = List.concat_map (Str.split (Str.regexp "__")) (String.split_on_char '.' path) in
  match List.rev parts with
  | name :: m :: _ -> m ^ "." ^ name
  | [ name ] -> inside ^ "." ^ name
  | [] -> path

let declare ~inside (d : type_declaration) =
  let name = inside ^ "." ^ d.typ_name.txt in
  let of_type (c : core_type) = fst (parse (tokens (printed c.ctyp_type))) in
  let of_field (f : label_declaration) = of_type f.ld_type in
  let of_constructor (c : constructor_declaration) =
    match c.cd_args with
    | Cstr_tuple types -> List.map of_type types
    | Cstr_record fields -> List.map of_field fields
  in
  let declared =
    match (d.typ_kind, d.typ_manifest) with
    | _ when d.typ_params <> [] -> Opaque
    | Ttype_variant constructors, _ -> Made_of (List.concat_map of_constructor constructors)
    | Ttype_record fields, _ -> Made_of (List.map of_field fields)
    | Ttype_abstract, Some manifest -> Made_of [ of_type manifest ]
    | _ -> Opaque
  in
  match (Hashtbl.find_opt types name, declared) with
  (* an interface may hide what the implementation declares: what it compares inside is plain all the same *)
  | Some Opaque, Made_of _ -> Hashtbl.replace types name declared
  | Some _, _ -> ()
  | None, _ -> Hashtbl.add types name declared

let base =
  [ "int"; "bool"; "char"; "string"; "float"; "unit"; "int64"; "int32"; "bytes"; "Int.t"; "String.t"; "Float.t";
    (* of other libraries *)
    "Unix.error"; "Xmlm.name" ]

let containers = [ "list"; "option"; "array"; "result" ]

(* A type that contains itself is plain if all else in it is. *)
let is_plain ~inside ty =
  let rec plain ~inside within = function
    | Other -> false
    | Tuple parts -> List.for_all (plain ~inside within) parts
    | Name (name, []) when List.mem name base -> true
    | Name (name, arguments) when List.mem name containers -> List.for_all (plain ~inside within) arguments
    | Name (name, _) -> (
        let key = key ~inside name in
        List.mem key within
        ||
        match Hashtbl.find_opt types key with
        | Some (Made_of parts) ->
          List.for_all (plain ~inside:(List.hd (String.split_on_char '.' key)) (key :: within)) parts
        | Some Opaque | None -> false)
  in
  plain ~inside [] ty

(* {1 Uses} *)

let by_structure =
  [ "="; "<>"; "<"; ">"; "<="; ">="; "compare"; "min"; "max";
    "List.mem"; "List.assoc"; "List.assoc_opt"; "List.mem_assoc"; "List.remove_assoc"; "Array.mem";
    "Hashtbl.hash"; "Hashtbl.find"; "Hashtbl.find_opt"; "Hashtbl.mem"; "Hashtbl.add"; "Hashtbl.replace";
    "Hashtbl.remove" ]

let function_of path =
  let name = Path.name path in
  let prefixes = [ "Stdlib."; "Scc_base.Constant_stack."; "Scc_base__Constant_stack." ] in
  let without prefix =
    let n = String.length prefix and length = String.length name in
    if length > n && String.sub name 0 n = prefix then Some (String.sub name n (length - n)) else None
  in
  let stripped = List.find_map without prefixes in
  let stripped = Option.map (Str.global_replace (Str.regexp "^\\(List\\|Hashtbl\\|Array\\)__") "") stripped in
  Option.bind stripped (fun f -> if List.mem f by_structure then Some f else None)

(* What is compared: the first argument, or the keys of a table. *)
let compared f type_expr =
  match parse (tokens (printed type_expr)) with
  | Name (("Stdlib.Hashtbl.t" | "Hashtbl.t"), [ key; _ ]), _ when f <> "Hashtbl.hash" -> key
  | ty, _ -> ty

let is_constant (e : expression) =
  match e.exp_desc with
  | Texp_construct (_, _, []) | Texp_constant _ | Texp_variant (_, None) -> true
  | _ -> false

(* Files with a function of any keys: the list functions of Stdlib anew, and what numbers keys as they come. Who
   calls these passes integers and strings, and lists and pairs of them. *)
let generic =
  [ "lib/foundation/base/constant_stack.ml"; "lib/formats/export/figure.ml"; "lib/formats/export/simularium.ml" ]

let is_generic (loc : Location.t) = function
  | Name (name, []) -> name.[0] = '\'' && List.mem loc.loc_start.pos_fname generic
  | _ -> false

let faults = ref 0
let uses = ref 0

let report (loc : Location.t) f type_expr =
  incr faults;
  Printf.printf "%s:%d: %s of %s\n" loc.loc_start.pos_fname loc.loc_start.pos_lnum f (printed type_expr)

let look ~inside (e : expression) f ~constant =
  incr uses;
  let what = compared f e.exp_type in
  if not (constant || is_plain ~inside what || is_generic e.exp_loc what) then report e.exp_loc f e.exp_type

let iterator ~inside =
  let super = Tast_iterator.default_iterator in
  let expr self (e : expression) =
    match e.exp_desc with
    | Texp_apply (({ exp_desc = Texp_ident (path, _, _); _ } as called), arguments)
      when function_of path <> None ->
      let constant = List.exists (function _, Some a -> is_constant a | _, None -> false) arguments in
      let f = Option.get (function_of path) in
      look ~inside called f ~constant:(constant && (f = "=" || f = "<>"));
      List.iter (function _, Some a -> self.Tast_iterator.expr self a | _, None -> ()) arguments
    | Texp_ident (path, _, _) when function_of path <> None ->
      look ~inside e (Option.get (function_of path)) ~constant:false
    | _ -> super.expr self e
  in
  { super with expr }

(* {1 Files} *)

let declarations ~inside =
  let super = Tast_iterator.default_iterator in
  let current = ref inside in
  let within name visit =
    let before = !current in
    current := Option.value name ~default:before;
    visit ();
    current := before
  in
  let type_declaration self d =
    declare ~inside:!current d;
    super.Tast_iterator.type_declaration self d
  in
  let module_binding self (b : module_binding) = within b.mb_name.txt (fun () -> super.module_binding self b) in
  let module_declaration self (b : module_declaration) =
    within b.md_name.txt (fun () -> super.module_declaration self b)
  in
  { super with type_declaration; module_binding; module_declaration }

let each iterator cmt = Trees.visit (iterator ~inside:(Trees.module_of cmt)) cmt

let () =
  let all = Trees.read Sys.argv.(1) in
  List.iter (each declarations) all;
  List.iter (each iterator) all;
  Printf.printf "%d comparisons by structure, %d of what is no plain data\n" !uses !faults;
  if all = [] || !faults > 0 then exit 1
