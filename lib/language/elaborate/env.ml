open Scc_base
open Scc_exact
open Scc_syntax
module Names = Map.Make (String)

type value =
  | Number of Rat.t
  | Truth of bool
  | Vector of Vec.t
  | Affine of Form.t
  | Open of Scc_calculus.Open_number.t
  | Word of string * t
  | Macro of Ast.expr * t
  | Leaf of int
  | Unknown

and binding = { value : value; span : Span.t; mutable used : bool }
and t = { values : binding Names.t; scope : scope }

and scope = {
  prefix : string;
  file : string;
  missing : bool;
  modules : (string, scope) Hashtbl.t;
  chosen : (string, string) Hashtbl.t;
  top : (string, binding) Hashtbl.t;
  declared : (string, unit) Hashtbl.t;
}

let scope ?(missing = false) ~prefix ~file () =
  {
    prefix;
    file;
    missing;
    modules = Hashtbl.create 4;
    chosen = Hashtbl.create 4;
    top = Hashtbl.create 16;
    declared = Hashtbl.create 16;
  }

let root scope = { values = Names.empty; scope }
let add name binding env = { env with values = Names.add name binding env.values }

let read b =
  b.used <- true;
  b.value

let find env name = Option.map read (Names.find_opt name env.values)
let mem env name = Names.mem name env.values
let is_module env name = (not (mem env name)) && Hashtbl.mem env.scope.modules name

let value env (segments : Ast.segment list) =
  match segments with
  | { name; indices = [] } :: rest when mem env name.it -> Option.map (fun v -> (v, rest)) (find env name.it)
  | { name = q; indices = [] } :: { name; indices = [] } :: rest -> (
      match Hashtbl.find_opt env.scope.modules q.it with
      | Some m -> Option.map (fun b -> (read b, rest)) (Hashtbl.find_opt m.top name.it)
      | None -> None)
  | _ -> None

let global env qualifier name =
  match qualifier with
  | None -> (
      match Hashtbl.find_opt env.scope.chosen name with
      | Some global -> Some global
      | None -> Some (env.scope.prefix ^ name))
  | Some q -> Option.map (fun m -> m.prefix ^ name) (Hashtbl.find_opt env.scope.modules q)

let after prefix name =
  let n = String.length prefix in
  if String.starts_with ~prefix name then Some (String.sub name n (String.length name - n)) else None

let written env name =
  let { prefix; chosen; modules; _ } = env.scope in
  let own = if String.equal prefix "" && String.contains name '.' then None else after prefix name in
  let by_module q m = Option.map (fun rest -> q ^ "." ^ rest) (after m.prefix name) in
  let add found all = Option.fold ~none:all ~some:(fun n -> n :: all) found in
  let chosen = Hashtbl.fold (fun n global all -> if String.equal global name then n :: all else all) chosen [] in
  let qualified = Hashtbl.fold (fun q m all -> add (by_module q m) all) modules [] in
  let first = List.sort String.compare in
  List.nth_opt (first chosen @ add own (first qualified)) 0

let said env label =
  let rec stop i = if i < String.length label && label.[i] <> '(' && label.[i] <> '[' then stop (i + 1) else i in
  let n = stop 0 in
  let name = String.sub label 0 n in
  Option.value ~default:name (written env name) ^ String.sub label n (String.length label - n)

let is_missing env qualifier =
  match Hashtbl.find_opt env.scope.modules qualifier with Some m -> m.missing | None -> false

let scope_of env = env.scope
let is_own env = String.equal env.scope.prefix ""
let own env name = env.scope.prefix ^ name

let declares env name = Hashtbl.mem env.scope.declared name || Hashtbl.mem env.scope.chosen name

let names env = List.map fst (Names.bindings env.values)
let modules env = Hashtbl.fold (fun name _ all -> name :: all) env.scope.modules [] |> List.sort String.compare

let beside env path =
  let folder = Filename.dirname env.scope.file in
  if Filename.is_relative path && not (String.equal folder Filename.current_dir_name) then
    Filename.concat folder path
  else path
