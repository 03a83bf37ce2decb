open Scc_base
open Scc_syntax

type meaning =
  | Declared of Declared.t list
  | Alike of Declared.t list
  | Channel
  | Word of Vocabulary.entry
  | Of_module of Declared.t
  | Feature
  | Unknown

type use = { name : Ast.name; meaning : meaning Lazy.t }
type how = As_name | As_co_name | Weak | Strong | Bond | Asked | Passed
type channel_use = { how : how; owner : string; at : Span.t }

(* What the argument of a family is used as within it: at once, or passed on to another one. *)
type passed = As_channel | As_feature | As_behaviour | To of Ast.name * int

type t = {
  all : Declared.all;
  uses : (int, use) Hashtbl.t;
  channels : (string, channel_use) Hashtbl.t;
  mutable passed : (string * channel_use * meaning Lazy.t) list;  (* arguments that may be channels *)
  arguments : (int, passed) Hashtbl.t;  (* by where an argument is declared *)
  families : (string, Ast.name list) Hashtbl.t;  (* behaviours and their arguments *)
  wearers : Wearers.t;
}

module Names = Map.Make (String)

(* Where something stands. *)
type context = {
  values : Declared.t Names.t;
  law : bool;  (* of a law of motion *)
  within : Declared.t list;  (* in whose solids features are looked up *)
  owner : string;
}

let text fmt = Printf.sprintf fmt
let add t (name : Ast.name) meaning = Hashtbl.replace t.uses name.at.start { name; meaning }
let known t name m = add t name (Lazy.from_val m)
let bind c (d : Declared.t) = { c with values = Names.add d.name.it d c.values }
let lexical c name = Names.find_opt name c.values
let word category name = Option.map (fun e -> Word e) (Vocabulary.find category name)

(* The first that there is. *)
let rec first = function
  | [] -> Unknown
  | f :: rest -> ( match f () with Some m -> m | None -> first rest)

let argument c name =
  match lexical c name with Some ({ kind = Argument; _ } as d) -> Some d | Some _ | None -> None

let among table name () =
  match Declared.find table name with [] -> None | found -> Some (Declared found)

let local c name () = Option.map (fun d -> Declared [ d ]) (lexical c name)

(* {1 Channels} *)

let name_channel t (c : context) how (name : Ast.name) =
  match argument c name.it with
  | Some d ->
    Hashtbl.add t.arguments d.name.at.start As_channel;
    known t name (Declared [ d ])
  | None ->
    Hashtbl.add t.channels name.it { how; owner = c.owner; at = name.at };
    known t name Channel

(* {1 Features} *)

(* What may follow the name of something after a dot: images have the features of what they are images of. *)
let inside t within name =
  (* Each template is looked into once: images may be of themselves, or declared many times. *)
  let seen = Hashtbl.create 8 in
  let rec of_declared (d : Declared.t) =
    match (Declared.find (Lazy.force d.by_name) name, d.solid) with
    | [], Some s -> of_solid s
    | found, _ -> found
  and of_solid (s : Ast.solid) =
    match s.it with
    | Scaled (s, _) -> of_solid s
    | Template { qualifier = None; target; _ } when not (Hashtbl.mem seen target.it) ->
      Hashtbl.add seen target.it ();
      List.concat_map of_declared (Declared.find t.all.templates target.it)
    | Template _ | Mesh _ | Faces _ | Hull _ -> []
  in
  List.concat_map of_declared within

let in_some t within name () =
  match inside t within name with
  | [] -> None
  | found -> Some (Declared found)

let alike t name () =
  match Declared.find t.all.features name with [] -> None | found -> Some (Alike found)

let feature_name t (c : context) name ~alone =
  let of_argument () = Option.map (fun d -> Declared [ d ]) (argument c name) in
  let body () = if alone then None else among t.all.bodies name () in
  first [ in_some t c.within name; of_argument; body; alike t name; (fun () -> Some Feature) ]

let make all wearers =
  {
    all;
    wearers;
    uses = Hashtbl.create 256;
    channels = Hashtbl.create 16;
    passed = [];
    arguments = Hashtbl.create 16;
    families = Hashtbl.create 16;
  }

let nowhere = { values = Names.empty; law = false; within = []; owner = "" }
