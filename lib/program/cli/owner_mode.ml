open Scc_base
open Scc_verdicts
open Scc_owners

open Cmdliner

type t = { place : Owner.place; address : string }

let listen address =
  let failed what =
    Error [ Diag.error Code.not_asked Span.command_line "cannot listen at `%s': %s" address what ]
  in
  match Unix.getaddrinfo address "0" [ AI_SOCKTYPE SOCK_STREAM; AI_PASSIVE ] with
  | [] -> failed "nobody knows this name"
  | { ai_addr; _ } :: _ -> (
      let fd = Unix.socket ~cloexec:true (Unix.domain_of_sockaddr ai_addr) SOCK_STREAM 0 in
      match
        Unix.bind fd ai_addr;
        Unix.listen fd 1024
      with
      | () -> Ok fd
      | exception Unix.Unix_error (e, _, _) -> failed (Unix.error_message e))

let port fd = match Unix.getsockname fd with ADDR_INET (_, port) -> port | ADDR_UNIX _ -> 0

let run console t filter ~listener ~identity =
  let program = Version.told ^ " " ^ Scc_build.Build.digest in
  match Owner.run filter t.place ~listener ~program ~identity with
  | () -> Ok Exit_code.Holds
  | exception Failure.Failed (Refused d) -> Error [ d ]
  | exception Failure.Failed (Lost why) -> Ok (Guard.stopped console why)
  | exception Sys_error why -> raise (Console.output_failed "what is kept" why)
  | exception Scc_system.Standard.Closed -> Ok Exit_code.Stopped
  | exception Scc_system.Standard.Failed why -> raise (Console.output_failed "standard output" why)

(* {1 Options} *)

let most_owners = 1000

let place =
  let parse s =
    match List.map int_of_string_opt (String.split_on_char '/' s) with
    | [ Some number; Some count ] when 1 <= number && number <= count && count <= most_owners ->
      Ok { Owner.number = number - 1; count }
    | _ ->
      let told = Printf.sprintf "`%s' is no owner: the third of eight is 3/8, and %d is the most" s most_owners in
      Error (`Msg told)
  in
  Arg.conv ~docv:"K/N" (parse, fun ppf (p : Owner.place) -> Format.fprintf ppf "%d/%d" (p.number + 1) p.count)

let term =
  let owner =
    Options.maybe place [ "owner" ] ~docv:"K/N"
      "Is owner $(i,K) of $(i,N) processes that explore the model together, with $(i,K) from 1 on. It keeps its \
       part of the states, and exchanges states with the others directly. See $(b,specs/successors.md)."
  in
  let address =
    Options.default Arg.string "127.0.0.1" [ "listen" ] ~docv:"ADDRESS"
      "With $(b,--owner): the address of this machine at which other owners call this one, at a free port. The \
       header has the port."
  in
  Term.(const (fun owner address -> Option.map (fun place -> { place; address }) owner) $ owner $ address)
