open Scc_base
open Scc_syntax
open Scc_calculus

type t = { included : bool array; index : int array; laws : (Law.t * Span.t) array; lattices : Lattices.t list }

let single report env (path : Ast.path) =
  match path.it with
  | [ segment ] -> Option.map (fun name -> (name, path.at)) (Constant.segment report env segment)
  | _ ->
    Report.error report Code.wrong_kind path.at
      "the name of a process is expected here, without a part or feature";
    None

let find report (bodies : Bodies.t) (name, at) =
  match Registry.find bodies.registry name with
  | Some target -> Some target
  | None ->
    Registry.unknown bodies.registry report at name;
    None

(* {1 network} *)

let leaves : Registry.target -> int list = function
  | Leaf i -> [ i ]
  | Process list | Family list -> list

let process_of (bodies : Bodies.t) =
  let owner = Array.make (Array.length bodies.leaves) (-1) in
  let enter p (process : Bodies.process) = List.iter (fun i -> owner.(i) <- p) process.members in
  Array.iteri enter bodies.processes;
  owner

(* A process is listed whole, by its own name: the label of one of its leaves does not stand for it. *)
let check_whole report (bodies : Bodies.t) owner (name, at) (target : Registry.target) =
  match target with
  | Process _ | Family _ -> true
  | Leaf i ->
    let p = bodies.processes.(owner.(i)) in
    let whole = (not p.labelled) || List.length p.members = 1 in
    if not whole then
      Report.error report Code.wrong_kind at "`%s` is a part of the process `%s`" name p.name
        ~hint:(Printf.sprintf "list the whole process: `%s`" p.name);
    whole

let select report (bodies : Bodies.t) env paths =
  let owner = process_of bodies in
  let listed = Array.make (Array.length bodies.processes) None in
  let mark (name, at) p =
    match listed.(p) with
    | Some (first, _) when not (Span.equal first at) ->
      Report.error report Code.duplicate_name at "`%s` is in the network twice" bodies.processes.(p).name
        ~notes:[ (first, "the first is here") ]
    | Some _ -> ()
    | None -> listed.(p) <- Some (at, name)
  in
  let add path =
    let*? name = single report env path in
    let*? target = find report bodies name in
    if check_whole report bodies owner name target then
      List.iter (fun i -> mark name owner.(i)) (leaves target);
    Some ()
  in
  List.iter (fun path -> ignore (add path)) paths;
  Array.map (fun p -> p >= 0 && Option.is_some listed.(p)) owner

let included report (program : Program.t) (bodies : Bodies.t) =
  match program.network with
  | None -> Array.make (Array.length bodies.leaves) true
  | Some (env, paths, _) -> select report bodies env paths

let number included =
  let next = ref 0 in
  Array.map
    (fun is_in ->
       if is_in then begin
         incr next;
         !next - 1
       end
       else -1)
    included

(* {1 motion} *)

(* A law for one process overrides one for its family, and that one the general law. *)
let rank : Registry.target -> int = function
  | Family _ -> 1
  | Process _ -> 2
  | Leaf _ -> 3

type assignment = { law : Law.t * Diffusion.lattice option; rank : int; at : Span.t }

let is_fixed (bodies : Bodies.t) i =
  match bodies.leaves.(i) with
  | Some l -> l.fixed
  | None -> false

let leaf_name (bodies : Bodies.t) i =
  match bodies.leaves.(i) with
  | Some l -> l.name
  | None -> "?"

let assign report bodies laws (m : Program.motion) target law i =
  let rank = rank target in
  match laws.(i) with
  | _ when is_fixed bodies i ->
    Report.error report Code.fixed_motion m.at "`%s` is fixed, and has no law of motion" (leaf_name bodies i)
  | Some earlier when earlier.rank = rank ->
    Report.error report Code.duplicate_name m.at "`%s` has two laws of motion" (leaf_name bodies i)
      ~notes:[ (earlier.at, "the first is here") ]
  | Some earlier when earlier.rank > rank -> ()
  | Some _ | None -> laws.(i) <- Some { law; rank; at = m.at }

(* The general law, once. *)
let read_general report general (m : Program.motion) law =
  match general with
  | Some (_, first) ->
    Report.error report Code.duplicate_name m.at "there are two general laws of motion"
      ~notes:[ (first, "the first is here") ];
    general
  | None -> Some (law, m.at)

let read_motion report budget ~timestep (bodies : Bodies.t) laws general (m : Program.motion) =
  let law = Laws.law report budget ~timestep m.env m.law in
  match (m.target, law) with
  | None, None -> general
  | None, Some law -> read_general report general m law
  | Some path, law ->
    let assigned =
      let*? name = single report m.env path in
      let*? target = find report bodies name in
      let*? law = law in
      List.iter (assign report bodies laws m target law) (leaves target);
      Some ()
    in
    ignore assigned;
    general

let read_laws report (program : Program.t) (bodies : Bodies.t) =
  let budget = Typed.budget () in
  let laws = Array.make (Array.length bodies.leaves) None in
  let read = read_motion report budget ~timestep:program.timestep bodies laws in
  let general = List.fold_left read None program.motions in
  let law i =
    match (laws.(i), general) with
    | Some a, _ -> (a.law, a.at)
    | None, Some law when not (is_fixed bodies i) -> law
    | None, _ -> ((Law.Inertial, None), Span.none)
  in
  Array.init (Array.length bodies.leaves) law

(* Of the bodies that take part. *)
let lattices bodies included laws =
  let of_leaf i ((_, lattice), at) =
    if included.(i) then Option.map (fun lattice -> (leaf_name bodies i, lattice, at)) lattice else None
  in
  Lattices.of_bodies (List.filter_map Fun.id (Array.to_list (Array.mapi of_leaf laws)))

let read (c : Context.t) (program : Program.t) (bodies : Bodies.t) =
  let included = included c.report program bodies in
  let laws = read_laws c.report program bodies in
  {
    included;
    index = number included;
    laws = Array.map (fun ((law, _), at) -> (law, at)) laws;
    lattices = lattices bodies included laws;
  }
