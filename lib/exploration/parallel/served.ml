open Scc_base
open Scc_codec
open Scc_graph_search

module Make (L : Lts.S) (E : Lts.Exchange with type context = L.context) = struct
  module Wire = Wire.Make (E)

  type state = Tuple of int array | Place of { answer : int; step : int }
  type heading = { waited : float; worked : float; words : int }
  type answer = Look | Steps of { some : Lts.step list option; all : Lts.step list }

  let kept ~some ~all = match some with None -> all | Some some -> some @ all

  (** {2 Requests} *)

  let put_state wire b = function
    | Tuple tuple ->
      Packed.put_nat b 0;
      Wire.put_tuple wire b tuple
    | Place { answer; step } ->
      Packed.put_nat b (1 + answer);
      Packed.put_nat b (step - answer)

  (* Nothing, where it has been overwritten. *)
  let read_tuple wire answered source =
    match Packed.nat source with
    | 0 -> Some (Wire.read_tuple wire source)
    | n ->
      let answer = n - 1 in
      Answered.tuple answered ~answer ~step:(answer + Packed.nat source)

  (** {2 Replies} *)

  let put_seconds b seconds = Packed.put_nat b (int_of_float (1e6 *. Float.max 0. seconds))
  let read_seconds source = 1e-6 *. float_of_int (Packed.nat source)

  let put_heading b { waited; worked; words } =
    put_seconds b waited;
    put_seconds b worked;
    Packed.put_nat b words

  let read_heading source =
    let waited = read_seconds source in
    let worked = read_seconds source in
    { waited; worked; words = Packed.nat source }

  let put_look b = Packed.put_nat b 0

  let put_steps wire b steps =
    Packed.put_nat b (List.length steps);
    List.iter (Wire.put_recent wire b) steps

  let read_steps wire source = Packed.list source (Wire.read_recent wire)

  let read_answer wire source =
    match Packed.nat source with
    | 0 -> Look
    | 1 -> Steps { some = None; all = read_steps wire source }
    | _ ->
      let some = read_steps wire source in
      Steps { some = Some some; all = read_steps wire source }

  (** {2 Serving} *)

  let answer context wire answered b tuple =
    match (L.reduced context tuple, L.successors context tuple) with
    | _, (Error _ | Ok []) -> put_look b
    | some, Ok all ->
      Packed.put_nat b (match some with None -> 1 | Some _ -> 2);
      Option.iter (put_steps wire b) some;
      put_steps wire b all;
      Answered.keep answered tuple (kept ~some ~all)

  let serve context channel =
    let from = Wire.make context and back = Wire.make context in
    let answered = Answered.create ~width:(L.width context) in
    let answers = Buffer.create 65536 and reply = Buffer.create 65536 in
    let rec go since =
      let source = Packed.source (Channel.get channel) in
      let start = Unix.gettimeofday () in
      Buffer.clear answers;
      for _ = 1 to Packed.nat source do
        match read_tuple from answered source with
        | Some tuple -> answer context back answered answers tuple
        | None -> put_look answers
      done;
      Buffer.clear reply;
      let worked = Unix.gettimeofday () -. start in
      let words = Memory.heap_words () + Answered.words answered in
      put_heading reply { waited = start -. since; worked; words };
      Buffer.add_buffer reply answers;
      Channel.put channel reply;
      go (Unix.gettimeofday ())
    in
    go (Unix.gettimeofday ())
end
