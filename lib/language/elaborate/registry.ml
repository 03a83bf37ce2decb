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
