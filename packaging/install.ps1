# Installs the program `meniscus` @VERSION@ for this user on Windows. Usage: .\install.ps1 [-Folder FOLDER].
# Remove it by deleting the folder. Upgrade by running the script of a later version.
param([string]$Folder = (Join-Path $env:LOCALAPPDATA 'Programs\Meniscus'))
$ErrorActionPreference = 'Stop'
$name = 'meniscus-x86_64-pc-windows-gnu.tar.gz'
$sum = '@SUM meniscus-x86_64-pc-windows-gnu.tar.gz@'
$work = Join-Path ([IO.Path]::GetTempPath()) ([IO.Path]::GetRandomFileName())
New-Item -ItemType Directory $work | Out-Null
try {
    $archive = Join-Path $work $name
    # MENISCUS_FILES: a folder with the files of the release, where nothing is to be fetched.
    if ($env:MENISCUS_FILES) {
        Copy-Item (Join-Path $env:MENISCUS_FILES $name) $archive
    } else {
        Invoke-WebRequest -UseBasicParsing "@DOWNLOADS@/download/v@VERSION@/$name" -OutFile $archive
    }
    if ((Get-FileHash -Algorithm SHA256 $archive).Hash -ne $sum) {
        throw 'The file is damaged or is not the one of this version; nothing was installed. Run the script again.'
    }
    tar -xzf $archive -C $work
    New-Item -ItemType Directory -Force $Folder | Out-Null
    Move-Item -Force (Join-Path $work 'meniscus.exe') (Join-Path $Folder 'meniscus.exe')
} finally {
    Remove-Item -Recurse -Force $work
}
$path = [Environment]::GetEnvironmentVariable('Path', 'User')
if (($path -split ';') -notcontains $Folder) {
    [Environment]::SetEnvironmentVariable('Path', "$path;$Folder", 'User')
    Write-Output "$Folder is in your Path from the next window on."
}
Write-Output "$Folder\meniscus.exe is installed."
