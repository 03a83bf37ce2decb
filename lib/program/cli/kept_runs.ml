open Scc_parallel
open Scc_store
open Scc_workers

type 'a t = {
  store : Store.t option;
  log : Log.t;
  blocks : Blocks.t;
  mutable block : string;  (** that is read *)
  mutable place : int;  (** of the next outcome in it *)
  elsewhere : Runs_elsewhere.t option;  (** where others make the runs *)
}

let start ?elsewhere store about =
  let log = Option.fold ~none:Log.none ~some:(fun s -> Store.log s about) store in
  { store; log; blocks = Blocks.make log; block = ""; place = 0; elsewhere }

let openly ?elsewhere console ~folder ~identity about =
  match folder with
  | None -> Ok (start ?elsewhere None about)
  | Some folder ->
    Kept.openly console ~folder identity |> Result.map (fun store -> start ?elsewhere (Some store) about)

(* A block has been seen to be what a process of the same build has written. *)
let rec next t =
  if t.place < String.length t.block then begin
    let outcome = Marshal.from_string t.block t.place in
    t.place <- t.place + Marshal.total_size (Bytes.unsafe_of_string t.block) t.place;
    Some outcome
  end
  else
    match t.log.next () with
    | None -> None
    | Some block ->
      t.block <- block;
      t.place <- 0;
      next t

let keep t outcome =
  if Option.is_some t.store then
    Blocks.add t.blocks (fun buffer -> Buffer.add_string buffer (Marshal.to_string outcome []))

let run ?patience ?(whole = fun _ -> true) ?(turn = 0) t ~jobs ~first ~count ~work ~interrupted ~each =
  let rec follow k =
    if k >= count then Ok ()
    else if interrupted () then Error Pool.Interrupted
    else
      match next t with
      | Some outcome ->
        each k outcome;
        follow (k + 1)
      | None ->
        let each k outcome =
          if whole outcome then keep t outcome;
          each k outcome
        in
        (match t.elsewhere with
         | Some others -> Runs_elsewhere.run others ~turn ~first:k ~count ~interrupted ~each
         | None -> Pool.run ?patience ~jobs ~first:k ~count ~work ~interrupted ~each ())
  in
  Fun.protect ~finally:(fun () -> Blocks.write t.blocks) (fun () -> follow first)

let lost ~what ~task ~how = Printf.sprintf "%s %d is lost: %s" what task how
let loss ~fault = if fault then Scc_verdicts.Exit_code.Bug else Stopped

let stopped ?(why = "interrupted") ?(partly = 0) console ~what ~written ~count (stop : Pool.stop) =
  let all = Printf.sprintf "%d of %d %ss" written count what in
  let others =
    if partly = 0 then ""
    else if partly = 1 then "; 1 more is written as far as it came"
    else Printf.sprintf "; %d more are written as far as they came" partly
  in
  match stop with
  | Interrupted ->
    Console.note console (Printf.sprintf "scc: %s after %s, which are written%s" why all others);
    Scc_verdicts.Exit_code.Stopped
  | Lost { task; how; fault } ->
    Console.note console (Printf.sprintf "scc: %s; %s are written" (lost ~what ~task ~how) all);
    loss ~fault

let close t =
  match t.store with
  | None -> []
  | Some store ->
    Store.close store;
    Option.to_list (Store.failed store)

let finish console t code =
  let unkept = close t in
  Kept.conclude console unkept;
  Scc_verdicts.Exit_code.worst (code :: Kept.code unkept)
