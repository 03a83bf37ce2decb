open Scc_base
open Scc_syntax
open Scc_calculus
open Scc_property

type t = {
  c : Context.t;
  bodies : Bodies.t;
  composition : Composition.t;
  behaviours : Behaviours.t;
  by_template : (string, int list) Hashtbl.t;  (* indices in the model, in order *)
  numbers : int array;  (* the declared number of each leaf of the model *)
  budget : Typed.budget;
  law_budget : Typed.budget;
}

let error t ?hint ?near code at fmt = Report.error t.c.report ?hint ?near code at fmt

(* {1 Arguments} *)

(* The one leaf that a name stands for, as an index in the model. *)
let resolve_leaf t (name, at) =
  let number =
    match Registry.find t.bodies.registry name with
    | Some (Leaf i) | Some (Process [ i ]) -> Some i
    | Some (Process [] | Family []) ->
      error t Code.wrong_kind at "`%s` is a family that has no members here, and one body is expected" name;
      None
    | Some (Process _ | Family _) ->
      error t Code.wrong_kind at "`%s` stands for several bodies, and one is expected here" name
        ~hint:"name one of them, or use `forall`, `exists` or `count`";
      None
    | None ->
      Registry.unknown t.bodies.registry t.c.report at name;
      None
  in
  let*? i = number in
  if t.composition.index.(i) >= 0 then Some t.composition.index.(i)
  else begin
    error t Code.wrong_kind at "`%s` is not in the network" name;
    None
  end

let leaf t env (e : Ast.expr) =
  match e.it with
  | Path path -> (
      let bound =
        match path.it with
        | [ { name; indices = [] } ] -> Env.find env name.it
        | _ -> None
      in
      match bound with
      | Some (Env.Leaf i) -> Some i
      | Some (Number _ | Truth _ | Vector _ | Affine _ | Open _ | Word _ | Macro _ | Unknown) | None ->
        let*? name = Composition.single t.c.report env path in
        resolve_leaf t name)
  | _ ->
    error t Code.type_mismatch e.at "the name of a process is expected here";
    None

(* A part is named by its leaf and its own name: [arm.tip]. *)
let spot t env (e : Ast.expr) : Property.spot option =
  let whole leaf = { Property.leaf; part = None } in
  match e.it with
  | Path ({ it = path; at } as p) when List.length path > 1 -> (
      match List.rev path with
      | { name = part; indices = [] } :: (_ :: _ as before) ->
        let*? leaf = leaf t env { e with it = Path { p with it = List.rev before } } in
        let*? { shape; _ } = Option.map (fun (l : Bodies.leaf) -> l) t.bodies.leaves.(t.numbers.(leaf)) in
        (match shape with
         | Compound c -> (
             match Shape.part_index c part.it with
             | Some k -> Some { Property.leaf; part = Some k }
             | None ->
               error t Code.unknown_feature part.at "`%s` has no part `%s`" (Env.said env c.clabel) part.it
                 ~near:(part.it, fun () -> Array.to_list (Array.map (fun (p : Shape.part) -> p.name) c.parts));
               None)
         | Basic _ ->
           error t Code.unknown_feature at "this body has no parts: name it alone";
           None)
      | _ -> Option.map whole (leaf t env e))
  | _ -> Option.map whole (leaf t env e)

let known_channel t (name : Ast.name) =
  if Behaviours.has_channel t.behaviours name.it then Some name.it
  else begin
    error t Code.unknown_name name.at "no behaviour or bond of the network has a channel `%s`" name.it
      ~near:(name.it, fun () -> Behaviours.channels t.behaviours);
    None
  end

let channel t (e : Ast.expr) =
  match e.it with
  | Path { it = [ { name; indices = [] } ]; _ } ->
    Option.map (fun a -> (None, a)) (known_channel t name)
  | Co name -> Option.map (fun a -> (Some Behaviour.Co_name, a)) (known_channel t name)
  | _ ->
    error t Code.type_mismatch e.at "the name of a channel is expected here";
    None

(* A process where a channel is expected is likely one argument too early. *)
let bond_name t env (e : Ast.expr) =
  match e.it with
  | Path { it = [ { name; indices = [] } ]; _ } when Behaviours.has_channel t.behaviours name.it ->
    Some name.it
  | Path { it = { name; _ } :: _; _ }
    when Option.is_some (Registry.find t.bodies.registry name.it) || Option.is_some (Env.find env name.it) ->
    error t Code.wrong_kind e.at "the name of a channel is expected here, and `%s` is none" name.it
      ~hint:"the channel comes first, and processes after it, as in `bind(a, p, q)`";
    None
  | Path { it = [ { name; indices = [] } ]; _ } -> known_channel t name
  | Co name ->
    error t Code.type_mismatch e.at "a bond has the plain name of its channel: `%s`" name.it;
    None
  | _ ->
    error t Code.type_mismatch e.at "the name of a channel is expected here";
    None

let owner t i =
  Option.map
    (fun (l : Bodies.leaf) -> { Behaviours.name = l.name; shape = l.shape })
    t.bodies.leaves.(t.numbers.(i))

let reference_of (e : Ast.expr) =
  let plain target = { Ast.qualifier = None; target; indices = []; arguments = [] } in
  match e.it with
  | Path { it = [ { name; indices } ]; _ } -> Some { (plain name) with indices }
  | Path { it = [ { name = q; indices = [] }; { name; indices } ]; _ } ->
    Some { (plain name) with qualifier = Some q; indices }
  | Apply (f, arguments) -> Some { (plain f) with arguments }
  | Apply_in ({ it = [ { name = q; indices = [] } ]; _ }, f, arguments) ->
    Some { (plain f) with qualifier = Some q; arguments }
  | _ -> None

(* Of a family, its name alone is all of its members. *)
let template_of e =
  match reference_of e with Some { indices = _ :: _; _ } -> None | reference -> reference

let of_template t label = Option.value ~default:[] (Hashtbl.find_opt t.by_template label)

let template_members t env r =
  let*? r = r in
  let scratch = Report.create () in
  let*? reference = Family.reference scratch env r in
  let made = Option.bind (Solids.label r reference) (fun l -> if Hashtbl.mem t.c.made l then Some l else None) in
  match (Hashtbl.find_opt t.c.templates reference.label, made) with
  | Some template, _ ->
    template.used <- true;
    Some (of_template t reference.label)
  | None, Some label -> Some (of_template t label)
  | None, None ->
    let family key _ found = found || String.equal (Family.bare key) reference.label in
    if Hashtbl.fold family t.c.families false || Hashtbl.mem t.by_template reference.label then
      Some (of_template t reference.label)
    else None

let body_members t env (e : Ast.expr) =
  let scratch = Report.create () in
  let*? name =
    match e.it with
    | Path { it = [ segment ]; _ } -> Constant.segment scratch env segment
    | _ -> None
  in
  let*? found = Registry.find t.bodies.registry name in
  match found with
  | Leaf i -> Some [ t.composition.index.(i) ]
  | Process list | Family list ->
    Some (List.map (fun i -> t.composition.index.(i)) (List.sort Int.compare list))

let range t env (e : Ast.expr) =
  match (template_members t env (template_of e), body_members t env e) with
  | Some members, _ | None, Some members -> Some members
  | None, None ->
    let name = Scc_syntax.Printer.expr e in
    let templates () =
      List.filter_map (fun key -> Env.written env (Family.bare key)) (Context.template_names t.c)
    in
    error t Code.unknown_name e.at "unknown template `%s`" name
      ?hint:(Registry.hint t.bodies.registry ~also:(templates ()) name);
    None

let create (c : Context.t) (bodies : Bodies.t) (composition : Composition.t) behaviours =
  let by_template = Hashtbl.create 16 in
  let all = List.init (Array.length bodies.leaves) Fun.id in
  let numbers = List.filter (fun i -> composition.included.(i)) all in
  let enter i =
    match bodies.leaves.(i) with
    | None -> ()
    | Some l ->
      let put label =
        let others = Option.value ~default:[] (Hashtbl.find_opt by_template label) in
        Hashtbl.replace by_template label (composition.index.(i) :: others)
      in
      let label = Shape.label l.shape in
      put label;
      let family = Family.bare label in
      if not (String.equal family label) then put family
  in
  List.iter enter (List.rev numbers);
  let budget = Typed.budget () and law_budget = Typed.budget () in
  { c; bodies; composition; behaviours; by_template; numbers = Array.of_list numbers; budget; law_budget }

let copy t c =
  {
    t with
    c;
    behaviours = Behaviours.copy t.behaviours c;
    budget = { t.budget with left = t.budget.left };
    law_budget = { t.law_budget with left = t.law_budget.left };
  }
