open Scc_base
open Scc_syntax

type target = Leaf of int | Process of int list | Family of int list

type entry = { mutable target : target; span : Span.t }
type t = { report : Report.t; entries : (string, entry) Hashtbl.t }

let create report = { report; entries = Hashtbl.create 64 }
let find t name = Option.map (fun e -> e.target) (Hashtbl.find_opt t.entries name)
let names t = Hashtbl.fold (fun name _ all -> name :: all) t.entries [] |> List.sort String.compare

let leaves = function
  | Leaf i -> [ i ]
  | Process list | Family list -> list

let taken t at name first =
  Report.error t.report Code.duplicate_name at "the name `%s` is taken by another process" name
    ~notes:[ (first, "the first is here") ]

let add_to_family t (s : Ast.segment) target =
  match Hashtbl.find_opt t.entries s.name.it with
  | None -> Hashtbl.add t.entries s.name.it { target = Family (leaves target); span = s.name.at }
  | Some ({ target = Family earlier; _ } as family) ->
    family.target <- Family (List.rev_append (leaves target) earlier)
  | Some { target = Leaf _ | Process _; span } -> taken t s.name.at s.name.it span

let declare_family t (name : Ast.name) =
  match Hashtbl.find_opt t.entries name.it with
  | None -> Hashtbl.add t.entries name.it { target = Family []; span = name.at }
  | Some { target = Family _; _ } -> ()
  | Some { target = Leaf _ | Process _; span } ->
    let first, second = if span.start < name.at.start then (span, name.at) else (name.at, span) in
    taken t second name.it first

let add t (s : Ast.segment) printed target =
  match Hashtbl.find_opt t.entries printed with
  | Some first -> taken t s.name.at printed first.span
  | None -> (
      Hashtbl.add t.entries printed { target; span = s.name.at };
      match s.indices with
      | [] -> ()
      | _ :: _ -> add_to_family t s target)

(* {1 Names that nothing has} *)

(* More of them would hide what is said. *)
let most_listed = 8

(* `c[2]` before `c[10]`. *)
let in_order names =
  let by_length a b =
    match Int.compare (String.length a) (String.length b) with 0 -> String.compare a b | k -> k
  in
  List.sort by_length names

(* Of a family that is there, its members are listed; otherwise the name of a body or family is suggested, without
   indices: those that are written stay. *)
let hint t ?(also = []) name =
  let all = names t in
  let family = Family.bare name in
  let is_member n = (not (String.equal n family)) && String.equal (Family.bare n) family in
  match in_order (List.filter is_member all) with
  | [] when (not (String.equal family name)) && Hashtbl.mem t.entries family -> (
      match find t family with
      | Some (Family _) -> Some (Printf.sprintf "`%s` is a family that has no members here" family)
      | _ -> Some (Printf.sprintf "`%s` is no family, and has no index" family))
  | [] -> Scc_base.Diag.suggest family (also @ List.sort_uniq String.compare (List.map Family.bare all))
  | members ->
    let shown = List.filteri (fun i _ -> i < most_listed) members in
    let more = if List.compare_length_with members most_listed > 0 then ", …" else "" in
    Some (Printf.sprintf "`%s` has %s%s" family (String.concat ", " (List.map (Printf.sprintf "`%s`") shown)) more)

let unknown t report at name =
  Report.error report Scc_base.Code.unknown_name at "unknown process `%s`" name ?hint:(hint t name)
