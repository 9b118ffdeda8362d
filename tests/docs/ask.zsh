# ask.zsh LINE: what zsh offers at the end of the line, one a line. A second zsh, on a terminal, prints its matches.
zmodload zsh/zpty
zpty shell zsh -f -i
until_said() {
    local line
    while zpty -r shell line; do
        line=${line//$'\r'/}
        [[ $line == *"<$1>"* && $line != *print* ]] && return
        [[ $1 == end && $line == *'offer<'* ]] && print -r -- ${${line##*offer<}%%>*}
    done
}
zpty -w shell 'PROMPT=; unset zle_bracketed_paste; stty -echo; print "<quiet>"'
until_said quiet
zpty -w shell 'autoload -Uz compinit; compinit -u -D; source ./_zsh
compadd() { local -a got; builtin compadd -O got "$@"; (( $#got )) && print -rl -- "offer<"${^got}">"; builtin compadd "$@" }
ask() { _main_complete; print "\n<end>" }; zle -C ask complete-word ask; bindkey "^T" ask; print "<ready>"'
until_said ready
zpty -w -n shell "$1"$'\x14'
until_said end
zpty -d shell
