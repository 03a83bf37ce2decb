open Scc_base
open Scc_exact
open Scc_syntax

let all options = if List.for_all Option.is_some options then Some (List.filter_map Fun.id options) else None
let blanks list = String.concat "," (List.map (fun _ -> "_") list)

(* {1 What is declared} *)

type head = { key : string; formals : Ast.name list }

(* A variable for an index: a name that nothing has. *)
let variable env (e : Ast.expr) =
  match e.it with
  | Path { it = [ { name; indices = [] } ]; _ } when not (Env.mem env name.it) -> Some name
  | _ -> None

let unknown formals = List.map (fun _ -> Env.Unknown) formals

let check_distinct report formals =
  let rec check = function
    | [] -> ()
    | (n : Ast.name) :: rest ->
      (match List.find_opt (fun (m : Ast.name) -> String.equal m.it n.it) rest with
       | Some (m : Ast.name) ->
         Report.error report Code.duplicate_name m.at "the parameter `%s` is given twice" m.it
           ~notes:[ (n.at, "the first is here") ]
       | None -> ());
      check rest
  in
  check formals

let integers report env es =
  all (List.map (Constant.index report env) es)
  |> Option.map (fun zs -> String.concat "," (List.map Z.to_string zs))

let check_chosen report env (name : Ast.name) =
  if Hashtbl.mem (Env.scope_of env).chosen name.it then
    Report.error report Code.duplicate_name name.at "the name `%s` is that of an import" name.it
      ~hint:"import it under another one, with `as`"

let head report (env : Env.t) (h : Ast.head) =
  check_chosen report env h.declared;
  let base = Env.own env h.declared.it in
  match (h.places, h.formals) with
  | [], [] -> Some { key = base; formals = [] }
  | [], formals ->
    check_distinct report formals;
    Some { key = Printf.sprintf "%s(%s)" base (blanks formals); formals }
  | places, _ -> (
      match all (List.map (variable env) places) with
      | Some formals ->
        check_distinct report formals;
        Some { key = Printf.sprintf "%s[%s]" base (blanks formals); formals }
      | None ->
        integers report env places
        |> Option.map (fun printed -> { key = Printf.sprintf "%s[%s]" base printed; formals = [] }))

(* {1 What is referred to} *)

type reference = { label : string; keys : string list; arguments : Env.value list }

let printed = function
  | Env.Number q -> Rat.to_string q
  | Truth b -> string_of_bool b
  | Vector v -> Vec.to_string v
  | Affine form -> Form.to_string form
  | Open n -> Rational_function.to_string ~variable:n.parameter.name n.form
  | Word (w, env) -> if Env.declares env w then Option.value ~default:w (Env.global env None w) else w
  | Unknown -> "_"
  | Macro _ | Leaf _ -> Bug.fail __POS__ "no argument of a family"

(* What depends on an unknown parameter is read for its faults, and is unknown. *)
let known_or_open env e = function
  | Some value -> Some value
  | None -> if Constant.is_open env e then Some Env.Unknown else None

let of_expr report env e = known_or_open env e (Constant.value report env e)

let argument report env (e : Ast.expr) =
  match e.it with
  | Path { it = [ { name; indices = [] } ]; _ } -> (
      match Env.find env name.it with
      | None -> Some (Env.Word (name.it, env))
      | Some ((Word _ | Unknown) as w) -> Some w
      | Some (Number _ | Truth _ | Vector _ | Affine _ | Open _ | Macro _ | Leaf _) -> of_expr report env e)
  | _ -> of_expr report env e

let index report env e =
  Option.map (fun z -> Env.Number (Rat.make z Z.one)) (Constant.index report env e)
  |> known_or_open env e

let base report env (r : Ast.reference) =
  let qualifier = Option.map (fun (q : Ast.name) -> q.it) r.qualifier in
  match (qualifier, Env.find env r.target.it) with
  | None, Some (Word (w, written)) -> Env.global written None w
  | None, Some Unknown -> None
  | _ -> (
      match Env.global env qualifier r.target.it with
      | Some name -> Some name
      | None ->
        Option.iter
          (fun (q : Ast.name) ->
             let of_library =
               if List.mem q.it Library.names then Some (Printf.sprintf "`import <%s>` is missing" q.it) else None
             in
             Report.error report Code.unknown_name q.at "no import is called `%s`" q.it ?hint:of_library
               ~near:(q.it, fun () -> Env.modules env))
          r.qualifier;
        None)

let reference report env (r : Ast.reference) =
  let*? base = base report env r in
  match (r.indices, r.arguments) with
  | [], [] -> Some { label = base; keys = [ base ]; arguments = [] }
  | [], arguments ->
    let*? values = all (List.map (argument report env) arguments) in
    Some
      {
        label = Printf.sprintf "%s(%s)" base (String.concat "," (List.map printed values));
        keys = [ Printf.sprintf "%s(%s)" base (blanks values) ];
        arguments = values;
      }
  | indices, _ ->
    let*? values = all (List.map (index report env) indices) in
    let label = Printf.sprintf "%s[%s]" base (String.concat "," (List.map printed values)) in
    Some { label; keys = [ label; Printf.sprintf "%s[%s]" base (blanks values) ]; arguments = values }

let is_open reference = List.exists (function Env.Unknown -> true | _ -> false) reference.arguments

let find table reference =
  List.find_map (fun key -> Hashtbl.find_opt table key) reference.keys

(* With the same name, and as many indices. *)
let alike key key' =
  match (String.index_opt key '[', String.index_opt key' '[') with
  | Some i, Some j ->
    let indices key = List.length (String.split_on_char ',' key) in
    String.equal (String.sub key 0 i) (String.sub key' 0 j) && Int.equal (indices key) (indices key')
  | _ -> false

let has table reference =
  Option.is_some (find table reference)
  || (is_open reference && Hashtbl.fold (fun key _ found -> found || alike key reference.label) table false)

(* {1 Instances} *)

let word env name =
  match Env.find env name with
  | Some (Word (w, _)) -> w
  | _ -> name

let bind env formals arguments =
  let add env (n : Ast.name) value = Env.add n.it { Env.value; span = n.at; used = true } env in
  match formals with
  | [] -> env
  | _ :: _ -> List.fold_left2 add env formals arguments

let define report env definitions =
  let add env ((n : Ast.name), e) =
    let value =
      if Constant.is_constant env e then
        Option.value ~default:(Env.Number Rat.one) (Constant.value report env e)
      else begin
        if Constant.is_open env e then ignore (Constant.value report env e);
        Env.Macro (e, env)
      end
    in
    Env.add n.it { Env.value; span = n.at; used = true } env
  in
  List.fold_left add env definitions

let keys table = Hashtbl.fold (fun key _ all -> key :: all) table [] |> List.sort String.compare

let bare name =
  match (String.index_opt name '[', String.index_opt name '(') with
  | Some i, Some j -> String.sub name 0 (min i j)
  | Some i, None | None, Some i -> String.sub name 0 i
  | None, None -> name

(* More of them would hide what is said. *)
let most_listed = 24

let listed import names =
  if List.length names > most_listed then None
  else
    let quoted = List.map (Printf.sprintf "`%s`") names in
    Some (Printf.sprintf "`%s` has %s" import (String.concat ", " quoted))

(* The same name in imports of the text, or in a module that it might import. *)
let qualified env what known (r : Ast.reference) =
  let name = r.target.it in
  let declares import =
    match Env.global env (Some import) name with Some key -> List.mem key known | None -> false
  in
  let written import = Printf.sprintf "`%s.%s`" import name in
  match (List.filter declares (Env.modules env), Library.declaring what name) with
  | (_ :: _ as imports), _ -> Some ("did you mean " ^ String.concat " or " (List.map written imports) ^ "?")
  | [], Some library when not (Env.is_module env library) ->
    Some (Printf.sprintf "%s is in a module of scc: say `import <%s>`" (written library) library)
  | [], _ -> None

(* The reference as it is written, with the values of its arguments. *)
let as_written env (r : Ast.reference) (reference : reference) =
  match r.qualifier with
  | None -> Env.said env reference.label
  | Some q ->
    let n = String.length (bare reference.label) in
    q.it ^ "." ^ r.target.it ^ String.sub reference.label n (String.length reference.label - n)

(* Of the names that the text can write, those of the import that is named, without its name. *)
let of_import seen import =
  let prefix = import ^ "." in
  let n = String.length prefix in
  let inside name =
    if String.starts_with ~prefix name then Some (String.sub name n (String.length name - n)) else None
  in
  List.filter_map inside seen

let hint_of_unknown env what keys ~predefined (r : Ast.reference) name =
  let seen = List.sort_uniq String.compare (List.filter_map (fun key -> Env.written env (bare key)) keys) in
  match r.qualifier with
  | Some _ when List.exists (fun key -> String.equal (bare key) r.target.it) predefined ->
    Some (Printf.sprintf "did you mean `%s`? It needs no import" r.target.it)
  | Some import -> (
      match of_import seen import.it with
      | [] -> None
      | names ->
        let written name = Printf.sprintf "did you mean `%s.%s`?" import.it name in
        let nearest = Diag.nearest r.target.it names in
        let hints = [ Option.map written nearest; listed import.it names ] in
        Some (String.concat " " (List.filter_map Fun.id hints)))
  | None -> (
      match qualified env what (List.map bare keys) r with
      | Some hint -> Some hint
      | None -> Diag.suggest (bare name) (seen @ List.map bare predefined))

let report_unknown report env what keys ?(predefined = []) (r : Ast.reference) (reference : reference) =
  let of_family = bare reference.label in
  let instances = List.filter (fun key -> String.equal (bare key) of_family) keys in
  let of_scc =
    if Option.is_some r.qualifier then []
    else List.filter (fun key -> String.equal (bare key) r.target.it) predefined
  in
  let name = as_written env r reference in
  match List.map (Env.said env) instances @ of_scc with
  | [] ->
    let hint = match hint_of_unknown env what keys ~predefined r name with Some "" -> None | hint -> hint in
    let is_missing (q : Ast.name) = Env.is_missing env q.it in
    if not (Option.fold ~none:false ~some:is_missing r.qualifier) then
      Report.error report Code.unknown_name r.target.at ?hint "unknown %s `%s`" what name
  | _ :: _ as known ->
    Report.error report Code.unknown_name r.target.at "unknown %s `%s`; declared is %s" what name
      (String.concat ", " (List.map (Printf.sprintf "`%s`") known))
